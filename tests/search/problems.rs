//! Test problems with published optima: value, derivatives and source of each.

use beamtune::solve::Cancelled;
use beamtune::tune::search::{Evaluation, Function, Landscape, Merit};

/// A value and its derivatives by the variables themselves.
pub type Value = (f64, Vec<f64>);

/// Terms and limits.
pub type Values = (Vec<Vec<Value>>, Vec<Value>);

/// A problem over its own box.
#[derive(Clone)]
pub struct Problem {
    pub name: &'static str,
    /// Least and greatest value of every variable.
    pub bounds: Vec<[f64; 2]>,
    pub start: Vec<f64>,
    /// The published objective.
    pub optimum: f64,
    /// The published optimum, if the source gives it exactly.
    pub at: Option<Vec<f64>>,
    pub values: fn(&[f64]) -> Values,
}

impl Problem {
    pub fn start(&self) -> Vec<f64> {
        let both = self.start.iter().zip(&self.bounds);
        both.map(|(x, [min, max])| (x - min) / (max - min))
            .collect()
    }

    pub fn real(&self, x: &[f64]) -> Vec<f64> {
        let both = x.iter().zip(&self.bounds);
        both.map(|(x, [min, max])| min + x * (max - min)).collect()
    }

    fn function(&self, (value, gradient): Value) -> Function {
        let both = gradient.iter().zip(&self.bounds);
        let gradient = both.map(|(g, [min, max])| g * (max - min)).collect();
        Function { value, gradient }
    }
}

impl Landscape for Problem {
    fn variables(&self) -> usize {
        self.bounds.len()
    }

    fn merit(&self, x: &[f64]) -> Result<Merit, Cancelled> {
        self.evaluate(x).map(|evaluation| evaluation.merit())
    }

    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, Cancelled> {
        let (terms, limits) = (self.values)(&self.real(x));
        let all = |values: Vec<Value>| values.into_iter().map(|v| self.function(v)).collect();
        Ok(Evaluation {
            terms: terms.into_iter().map(all).collect(),
            limits: all(limits),
        })
    }
}

fn problem(
    name: &'static str,
    (min, max): (f64, f64),
    start: &[f64],
    optimum: f64,
    values: fn(&[f64]) -> Values,
) -> Problem {
    Problem {
        name,
        bounds: vec![[min, max]; start.len()],
        start: start.to_vec(),
        optimum,
        at: None,
        values,
    }
}

pub fn all() -> Vec<Problem> {
    vec![
        cb2(),
        cb3(),
        madsen(),
        rosen_suzuki(),
        dem(),
        davidon(),
        ql(),
        lq(),
        mifflin1(),
        wong1(),
        hs71(),
        hs76(),
        polak1(),
        bard(),
        chained(),
        rosenbrock(),
    ]
}

/// Charalambous & Conn, SIAM J. Numer. Anal. 1978, 15, 162-187, problem 2: 1.95222449.
pub fn cb2() -> Problem {
    problem("CB2", (-10.0, 10.0), &[1.0, -0.1], 1.952_224_493_9, |x| {
        let e = 2.0 * (x[1] - x[0]).exp();
        (
            vec![vec![
                (
                    x[0].powi(2) + x[1].powi(4),
                    vec![2.0 * x[0], 4.0 * x[1].powi(3)],
                ),
                (
                    (2.0 - x[0]).powi(2) + (2.0 - x[1]).powi(2),
                    vec![2.0 * (x[0] - 2.0), 2.0 * (x[1] - 2.0)],
                ),
                (e, vec![-e, e]),
            ]],
            vec![],
        )
    })
}

/// The same, problem 3: 2 at (1, 1).
pub fn cb3() -> Problem {
    let mut p = problem("CB3", (-10.0, 10.0), &[2.0, 2.0], 2.0, |x| {
        let e = 2.0 * (x[1] - x[0]).exp();
        (
            vec![vec![
                (
                    x[0].powi(4) + x[1].powi(2),
                    vec![4.0 * x[0].powi(3), 2.0 * x[1]],
                ),
                (
                    (2.0 - x[0]).powi(2) + (2.0 - x[1]).powi(2),
                    vec![2.0 * (x[0] - 2.0), 2.0 * (x[1] - 2.0)],
                ),
                (e, vec![-e, e]),
            ]],
            vec![],
        )
    });
    p.at = Some(vec![1.0, 1.0]);
    p
}

/// Madsen, J. Inst. Math. Appl. 1975, 16, 321-328: 0.61643244 of absolute values.
pub fn madsen() -> Problem {
    problem("Madsen", (-10.0, 10.0), &[3.0, 1.0], 0.616_432_435_6, |x| {
        let f = [
            (
                x[0] * x[0] + x[1] * x[1] + x[0] * x[1],
                vec![2.0 * x[0] + x[1], 2.0 * x[1] + x[0]],
            ),
            (x[0].sin(), vec![x[0].cos(), 0.0]),
            (x[1].cos(), vec![0.0, -x[1].sin()]),
        ];
        (vec![absolute(f)], vec![])
    })
}

fn absolute(values: impl IntoIterator<Item = Value>) -> Vec<Value> {
    values
        .into_iter()
        .flat_map(|(v, g)| [(v, g.clone()), (-v, g.iter().map(|g| -g).collect())])
        .collect()
}

/// Rosen & Suzuki as a minimax problem (Charalambous & Conn): -44 at (0, 1, 2, -1).
pub fn rosen_suzuki() -> Problem {
    let mut p = problem("Rosen-Suzuki", (-10.0, 10.0), &[0.0; 4], -44.0, |x| {
        let (f, c) = rosen_suzuki_parts(x);
        let mut pieces = vec![f.clone()];
        for (value, gradient) in c {
            let gradient =
                f.1.iter()
                    .zip(&gradient)
                    .map(|(f, c)| f + 10.0 * c)
                    .collect();
            pieces.push((f.0 + 10.0 * value, gradient));
        }
        (vec![pieces], vec![])
    });
    p.at = Some(vec![0.0, 1.0, 2.0, -1.0]);
    p
}

fn rosen_suzuki_parts(x: &[f64]) -> (Value, [Value; 3]) {
    let s: Vec<f64> = x.iter().map(|x| x * x).collect();
    let f = (
        s[0] + s[1] + 2.0 * s[2] + s[3] - 5.0 * x[0] - 5.0 * x[1] - 21.0 * x[2] + 7.0 * x[3],
        vec![
            2.0 * x[0] - 5.0,
            2.0 * x[1] - 5.0,
            4.0 * x[2] - 21.0,
            2.0 * x[3] + 7.0,
        ],
    );
    let c = [
        (
            s[0] + s[1] + s[2] + s[3] + x[0] - x[1] + x[2] - x[3] - 8.0,
            vec![
                2.0 * x[0] + 1.0,
                2.0 * x[1] - 1.0,
                2.0 * x[2] + 1.0,
                2.0 * x[3] - 1.0,
            ],
        ),
        (
            s[0] + 2.0 * s[1] + s[2] + 2.0 * s[3] - x[0] - x[3] - 10.0,
            vec![2.0 * x[0] - 1.0, 4.0 * x[1], 2.0 * x[2], 4.0 * x[3] - 1.0],
        ),
        (
            2.0 * s[0] + s[1] + s[2] + 2.0 * x[0] - x[1] - x[3] - 5.0,
            vec![4.0 * x[0] + 2.0, 2.0 * x[1] - 1.0, 2.0 * x[2], -1.0],
        ),
    ];
    (f, c)
}

/// Demyanov & Malozemov: -3 at (0, -3).
pub fn dem() -> Problem {
    let mut p = problem("DEM", (-10.0, 10.0), &[1.0, 1.0], -3.0, |x| {
        (
            vec![vec![
                (5.0 * x[0] + x[1], vec![5.0, 1.0]),
                (-5.0 * x[0] + x[1], vec![-5.0, 1.0]),
                (
                    x[0] * x[0] + x[1] * x[1] + 4.0 * x[1],
                    vec![2.0 * x[0], 2.0 * x[1] + 4.0],
                ),
            ]],
            vec![],
        )
    });
    p.at = Some(vec![0.0, -3.0]);
    p
}

/// Davidon 2: 115.70643952.
pub fn davidon() -> Problem {
    problem(
        "Davidon 2",
        (-50.0, 50.0),
        &[25.0, 5.0, -5.0, -1.0],
        115.706_439_5,
        |x| {
            let f = (1..=20).map(|i| {
                let t = 0.2 * f64::from(i);
                let a = x[0] + x[1] * t - t.exp();
                let b = x[2] + x[3] * t.sin() - t.cos();
                (
                    a * a + b * b,
                    vec![2.0 * a, 2.0 * a * t, 2.0 * b, 2.0 * b * t.sin()],
                )
            });
            (vec![absolute(f)], vec![])
        },
    )
}

/// QL (Womersley): 7.2 at (1.2, 2.4).
pub fn ql() -> Problem {
    let mut p = problem("QL", (-10.0, 10.0), &[-1.0, 5.0], 7.2, |x| {
        let f = x[0] * x[0] + x[1] * x[1];
        let g = [2.0 * x[0], 2.0 * x[1]];
        (
            vec![vec![
                (f, g.to_vec()),
                (
                    f + 10.0 * (-4.0 * x[0] - x[1] + 4.0),
                    vec![g[0] - 40.0, g[1] - 10.0],
                ),
                (
                    f + 10.0 * (-x[0] - 2.0 * x[1] + 6.0),
                    vec![g[0] - 10.0, g[1] - 20.0],
                ),
            ]],
            vec![],
        )
    });
    p.at = Some(vec![1.2, 2.4]);
    p
}

/// LQ (Womersley): -sqrt 2 at (1, 1) / sqrt 2.
pub fn lq() -> Problem {
    let mut p = problem(
        "LQ",
        (-10.0, 10.0),
        &[-0.5, -0.5],
        -std::f64::consts::SQRT_2,
        |x| {
            let f = -x[0] - x[1];
            (
                vec![vec![
                    (f, vec![-1.0, -1.0]),
                    (
                        f + x[0] * x[0] + x[1] * x[1] - 1.0,
                        vec![2.0 * x[0] - 1.0, 2.0 * x[1] - 1.0],
                    ),
                ]],
                vec![],
            )
        },
    );
    p.at = Some(vec![std::f64::consts::FRAC_1_SQRT_2; 2]);
    p
}

/// Mifflin 1: -1 at (1, 0); a sum of a line and a largest.
pub fn mifflin1() -> Problem {
    let mut p = problem("Mifflin 1", (-10.0, 10.0), &[0.8, 0.6], -1.0, |x| {
        (
            vec![
                vec![(-x[0], vec![-1.0, 0.0])],
                vec![
                    (0.0, vec![0.0, 0.0]),
                    (
                        20.0 * (x[0] * x[0] + x[1] * x[1] - 1.0),
                        vec![40.0 * x[0], 40.0 * x[1]],
                    ),
                ],
            ],
            vec![],
        )
    });
    p.at = Some(vec![1.0, 0.0]);
    p
}

/// Asaadi / Wong 1: 680.6300573.
pub fn wong1() -> Problem {
    problem(
        "Wong 1",
        (-10.0, 10.0),
        &[1.0, 2.0, 0.0, 4.0, 0.0, 1.0, 1.0],
        680.630_057_3,
        |x| {
            let f = (x[0] - 10.0).powi(2)
                + 5.0 * (x[1] - 12.0).powi(2)
                + x[2].powi(4)
                + 3.0 * (x[3] - 11.0).powi(2)
                + 10.0 * x[4].powi(6)
                + 7.0 * x[5].powi(2)
                + x[6].powi(4)
                - 4.0 * x[5] * x[6]
                - 10.0 * x[5]
                - 8.0 * x[6];
            let g = vec![
                2.0 * (x[0] - 10.0),
                10.0 * (x[1] - 12.0),
                4.0 * x[2].powi(3),
                6.0 * (x[3] - 11.0),
                60.0 * x[4].powi(5),
                14.0 * x[5] - 4.0 * x[6] - 10.0,
                4.0 * x[6].powi(3) - 4.0 * x[5] - 8.0,
            ];
            let c = [
                (
                    2.0 * x[0].powi(2)
                        + 3.0 * x[1].powi(4)
                        + x[2]
                        + 4.0 * x[3].powi(2)
                        + 5.0 * x[4]
                        - 127.0,
                    vec![
                        4.0 * x[0],
                        12.0 * x[1].powi(3),
                        1.0,
                        8.0 * x[3],
                        5.0,
                        0.0,
                        0.0,
                    ],
                ),
                (
                    7.0 * x[0] + 3.0 * x[1] + 10.0 * x[2].powi(2) + x[3] - x[4] - 282.0,
                    vec![7.0, 3.0, 20.0 * x[2], 1.0, -1.0, 0.0, 0.0],
                ),
                (
                    23.0 * x[0] + x[1].powi(2) + 6.0 * x[5].powi(2) - 8.0 * x[6] - 196.0,
                    vec![23.0, 2.0 * x[1], 0.0, 0.0, 0.0, 12.0 * x[5], -8.0],
                ),
                (
                    4.0 * x[0].powi(2) + x[1].powi(2) - 3.0 * x[0] * x[1]
                        + 2.0 * x[2].powi(2)
                        + 5.0 * x[5]
                        - 11.0 * x[6],
                    vec![
                        8.0 * x[0] - 3.0 * x[1],
                        2.0 * x[1] - 3.0 * x[0],
                        4.0 * x[2],
                        0.0,
                        0.0,
                        5.0,
                        -11.0,
                    ],
                ),
            ];
            let mut pieces = vec![(f, g.clone())];
            for (v, cg) in c {
                pieces.push((
                    f + 10.0 * v,
                    g.iter().zip(&cg).map(|(a, b)| a + 10.0 * b).collect(),
                ));
            }
            (vec![pieces], vec![])
        },
    )
}

/// Hock & Schittkowski 71 with its equality as the limit that it is at its optimum: 17.0140173 at (1, 4.7429994, 3.8211503, 1.3794082).
pub fn hs71() -> Problem {
    let mut p = problem(
        "HS71",
        (1.0, 5.0),
        &[1.0, 5.0, 5.0, 1.0],
        17.014_017_3,
        |x| {
            let product: f64 = x.iter().product();
            let squares: f64 = x.iter().map(|x| x * x).sum();
            let slope: Vec<f64> = x.iter().map(|x| 2.0 * x).collect();
            (
                vec![vec![(
                    x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2],
                    vec![
                        x[3] * (2.0 * x[0] + x[1] + x[2]),
                        x[0] * x[3],
                        x[0] * x[3] + 1.0,
                        x[0] * (x[0] + x[1] + x[2]),
                    ],
                )]],
                vec![
                    (25.0 - product, x.iter().map(|x| -product / x).collect()),
                    (squares - 40.0, slope),
                ],
            )
        },
    );
    p.at = Some(vec![1.0, 4.742_999_4, 3.821_150_3, 1.379_408_2]);
    p
}

/// Hock & Schittkowski 76, linear limits: -4.681818 at (0.2727273, 2.090909, 0, 0.5454545).
pub fn hs76() -> Problem {
    let mut p = problem("HS76", (0.0, 5.0), &[0.5; 4], -103.0 / 22.0, |x| {
        (
            vec![vec![(
                x[0] * x[0] + 0.5 * x[1] * x[1] + x[2] * x[2] + 0.5 * x[3] * x[3] - x[0] * x[2]
                    + x[2] * x[3]
                    - x[0]
                    - 3.0 * x[1]
                    + x[2]
                    - x[3],
                vec![
                    2.0 * x[0] - x[2] - 1.0,
                    x[1] - 3.0,
                    2.0 * x[2] - x[0] + x[3] + 1.0,
                    x[3] + x[2] - 1.0,
                ],
            )]],
            vec![
                (
                    x[0] + 2.0 * x[1] + x[2] + x[3] - 5.0,
                    vec![1.0, 2.0, 1.0, 1.0],
                ),
                (
                    3.0 * x[0] + x[1] + 2.0 * x[2] - x[3] - 4.0,
                    vec![3.0, 1.0, 2.0, -1.0],
                ),
                (1.5 - x[1] - 4.0 * x[2], vec![0.0, -1.0, -4.0, 0.0]),
            ],
        )
    });
    p.at = Some(vec![3.0 / 11.0, 23.0 / 11.0, 0.0, 6.0 / 11.0]);
    p
}

/// Polak, Mayne & Higgins (POLAK1 of CUTE): e = 2.71828183 at (0, 0).
pub fn polak1() -> Problem {
    let mut p = problem(
        "Polak 1",
        (-60.0, 60.0),
        &[50.0, 0.05],
        std::f64::consts::E,
        |x| {
            let pieces = [1.0, -1.0].map(|sign| {
                let e = (0.001 * x[0] * x[0] + (x[1] - sign).powi(2)).exp();
                (e, vec![e * 0.002 * x[0], e * 2.0 * (x[1] - sign)])
            });
            (vec![pieces.to_vec()], vec![])
        },
    );
    p.at = Some(vec![0.0, 0.0]);
    p
}

/// Bard's data as a minimax problem: 0.0508163266.
pub fn bard() -> Problem {
    problem(
        "Bard",
        (-5.0, 5.0),
        &[1.0, 1.0, 1.0],
        0.050_816_326_5,
        |x| {
            const Y: [f64; 15] = [
                0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39, 0.37, 0.58, 0.73, 0.96, 1.34, 2.10,
                4.39,
            ];
            let f = Y.iter().enumerate().map(|(i, y)| {
                let u = (i + 1) as f64;
                let v = 16.0 - u;
                let w = u.min(v);
                let below = v * x[1] + w * x[2];
                (
                    y - (x[0] + u / below),
                    vec![-1.0, u * v / below.powi(2), u * w / below.powi(2)],
                )
            });
            (vec![absolute(f)], vec![])
        },
    )
}

/// Chained CB3 II (Haarala, Miettinen & Makela): 2 (n - 1) at ones.
pub fn chained() -> Problem {
    let mut p = problem("chained CB3", (-10.0, 10.0), &[2.0; 10], 18.0, |x| {
        let terms = (0..x.len() - 1).map(|i| {
            let (a, b) = (x[i], x[i + 1]);
            let put = |da: f64, db: f64| {
                let mut g = vec![0.0; x.len()];
                g[i] = da;
                g[i + 1] = db;
                g
            };
            let e = 2.0 * (b - a).exp();
            vec![
                (a.powi(4) + b * b, put(4.0 * a.powi(3), 2.0 * b)),
                (
                    (2.0 - a).powi(2) + (2.0 - b).powi(2),
                    put(2.0 * (a - 2.0), 2.0 * (b - 2.0)),
                ),
                (e, put(-e, e)),
            ]
        });
        (terms.collect(), vec![])
    });
    p.at = Some(vec![1.0; 10]);
    p
}

/// Rosenbrock: 0 at (1, 1); smooth.
pub fn rosenbrock() -> Problem {
    let mut p = problem("Rosenbrock", (-5.0, 5.0), &[-1.2, 1.0], 0.0, |x| {
        let a = x[1] - x[0] * x[0];
        let b = 1.0 - x[0];
        (
            vec![vec![(
                100.0 * a * a + b * b,
                vec![-400.0 * a * x[0] - 2.0 * b, 200.0 * a],
            )]],
            vec![],
        )
    });
    p.at = Some(vec![1.0, 1.0]);
    p
}
