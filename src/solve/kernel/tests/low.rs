//! Low frequencies: closed forms, and both of the kernel's numbers against each other.

use super::*;
use crate::model::Checked;
use crate::solve::kernel::double_double::DoubleDouble;
use crate::solve::operating::operating;
use crate::solve::{SweepCache, sweep};

/// All responses, in doubles or in numbers of twice the digits.
fn solved(plan: &Plan, omegas: &[Complex64], is_low: bool) -> Vec<Vec<Complex64>> {
    let mut prepared = Prepared::new(plan.clone());
    prepared.low_limit = if is_low { f64::INFINITY } else { 0.0 };
    let mut columns = vec![vec![Complex64::ZERO; omegas.len()]; plan.outputs.len()];
    let mut out: Vec<&mut [Complex64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    Solver::default().solve(&prepared, omegas, &mut out);
    columns
}

/// The paper's section on a free beam of a length without subsystems, loads and responses.
fn bare(length: f64) -> Model {
    let mut model = read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    model.beam.length = length;
    model.subsystems.clear();
    model.forces.clear();
    model.responses.clear();
    (model.supports.left, model.supports.right) = (Support::FREE, Support::FREE);
    model
}

/// Adds a unit load, the response to it at the same place, and `E_V`.
fn drive(model: &mut Model, place: Place, motion: BeamMotion) {
    let target = Target::Beam(place, motion);
    model.forces.push(Force {
        enabled: true,
        point: Point::AXIS,
        target: target.clone(),
        amplitude: 1.0,
        phase: 0.0,
    });
    for quantity in [
        Quantity::Motion(target, Measure::Displacement),
        Quantity::Energy,
    ] {
        model.responses.push(Response {
            name: format!("R{}", model.responses.len()),
            enabled: true,
            point: Point::AXIS,
            quantity,
            over: None,
        });
    }
}

/// The responses at a frequency, Hz.
fn respond(model: &Model, frequency: f64) -> Vec<Complex64> {
    let plan = Plan::new(model);
    lanes(Instructions::available()[0], &plan, &[frequency])
}

fn assert_close(found: Complex64, expected: f64, case: &str) {
    let error = (found - expected).norm() / expected.abs();
    assert!(error < 1e-10, "{case}: {found} {expected:e}, {error:.1e}");
}

fn constants(model: &Model) -> BeamConstants {
    BeamConstants::new(&UniformPart::whole(model.beam), false)
}

const LENGTHS: [f64; 5] = [0.05, 0.5, 3.2, 30.0, 300.0];

/// Hz.
const FREQUENCIES: [f64; 6] = [1e-3, 1e-2, 0.1, 1.0, 20.0, 1000.0];

/// Closed form: `(cosh x sin x - sinh x cos x) / (E I kappa^3 (1 + cosh x cos x))` with x = kappa L, by the series of both
/// functions of x, which do not cancel; of a static shape `E_V` is 33/140 of the mass times the square of the tip's motion.
#[test]
fn a_cantilever_bends_as_its_closed_form_at_a_low_frequency() {
    for length in LENGTHS {
        let mut model = bare(length);
        model.supports.left = Support::CLAMPED;
        drive(&mut model, Place::Right, BeamMotion::V);
        let beam = constants(&model);
        let stiffness = beam.bending_v.re;
        for frequency in FREQUENCIES {
            let omega = std::f64::consts::TAU * frequency;
            let fourth = omega * omega * beam.mass / stiffness * length.powi(4);
            if fourth > 1.0 {
                continue;
            }
            let found = respond(&model, frequency);
            // (-4)^m x^4m / (4m)!
            let (mut above, mut below, mut term) = (0.0, 1.0, 1.0);
            for m in 0..8 {
                let k = f64::from(4 * m);
                below += term;
                above += term * 4.0 / ((k + 1.0) * (k + 2.0) * (k + 3.0));
                term *= -4.0 * fourth / ((k + 1.0) * (k + 2.0) * (k + 3.0) * (k + 4.0));
            }
            let expected = length.powi(3) / stiffness * above / below;
            let case = format!("{length} m, {frequency} Hz");
            assert_close(found[0], expected, &case);
            if (1e-14..1e-11).contains(&fourth) {
                let energy = 33.0 / 140.0 * beam.mass * length * expected * expected;
                assert_close(found[1], energy, &format!("energy, {case}"));
            }
        }
    }
}

/// Closed form: the static twist `(k x - sinh k x + tanh k L (cosh k x - 1)) / (k G J)` with k^2 = G J / E `Gamma_0`, by its
/// series on a short beam; and for `E_V` the integral of `rho I_0 psi^2` by Simpson's rule.
#[test]
fn a_cantilever_twists_as_its_closed_form_at_a_low_frequency() {
    for length in [0.05, 0.5, 3.2] {
        let mut model = bare(length);
        model.supports.left = Support::CLAMPED;
        drive(&mut model, Place::Right, BeamMotion::Psi);
        let beam = constants(&model);
        let k = (beam.torsion.re / beam.warping.re).sqrt();
        let twist = |x: f64| {
            let (at, end) = (k * x, (k * length).tanh());
            // sinh at - at, and cosh at - 1.
            let (mut odd, mut even, mut term) = (0.0, 0.0, at);
            for n in 1..30 {
                let n = f64::from(n);
                term /= 2.0 * n;
                even += term;
                term *= at / (2.0 * n + 1.0);
                odd += term;
                term *= at;
            }
            (end * at * even - at * odd) / (k * beam.torsion.re)
        };
        // The inertia is less by the square of the length in waves of twist.
        let found = respond(&model, 5e-5 / length);
        let case = format!("{length} m");
        assert_close(found[0], twist(length), &case);
        let steps = 2000;
        let square = |n: i32| twist(length * f64::from(n) / f64::from(steps)).powi(2);
        let inside: f64 = (1..steps)
            .map(|n| f64::from(2 + 2 * (n % 2)) * square(n))
            .sum();
        let integral = (inside + square(steps)) * length / f64::from(steps) / 3.0;
        assert_close(found[1], beam.polar * integral, &format!("energy, {case}"));
    }
}

/// Closed form: a rigid body, whose point under the force moves by `-(1 + 12 (x / L - 1/2)^2) / (omega^2 m L)`; what the beam
/// bends is less by `(kappa L)^4`.
#[test]
fn a_free_beam_moves_as_a_rigid_body_at_a_low_frequency() {
    for length in LENGTHS {
        let mut model = bare(length);
        drive(&mut model, Place::Position(0.8 * length), BeamMotion::V);
        let beam = constants(&model);
        let mass = beam.mass * length;
        for frequency in FREQUENCIES {
            let omega = std::f64::consts::TAU * frequency;
            if omega * omega * beam.mass / beam.bending_v.re * length.powi(4) > 1e-9 {
                continue;
            }
            let found = respond(&model, frequency);
            let expected = -(1.0 + 12.0 * 0.3 * 0.3) / (omega * omega * mass);
            let case = format!("{length} m, {frequency} Hz");
            assert_close(found[0], expected, &case);
            let energy = (1.0 + 12.0 * 0.3 * 0.3) / (omega.powi(4) * mass);
            assert_close(found[1], energy, &format!("energy, {case}"));
        }
    }
}

/// Closed form: a beam on two equal springs under a force at its middle, `1 / (2 k - omega^2 m L) + L^3 / (48 E I)`.
#[test]
fn a_beam_on_soft_or_stiff_springs_moves_as_its_closed_form_at_a_low_frequency() {
    for length in [0.05, 0.5] {
        for stiffness in [1e2, 1e6, 1e12] {
            let mut model = bare(length);
            let elastic = Elastic {
                spring: Spring {
                    stiffness,
                    ..Spring::default()
                },
                inertia: 0.0,
            };
            for support in [&mut model.supports.left, &mut model.supports.right] {
                support[BeamMotion::V] = Restraint::Elastic(elastic.clone());
            }
            drive(&mut model, Place::Position(0.5 * length), BeamMotion::V);
            let beam = constants(&model);
            let found = respond(&model, 1e-3);
            let square = (std::f64::consts::TAU * 1e-3_f64).powi(2);
            let rigid = 1.0 / (2.0 * stiffness - square * beam.mass * length);
            let expected = rigid + length.powi(3) / (48.0 * beam.bending_v.re);
            assert_close(
                found[0],
                expected,
                &format!("{length} m, {stiffness:e} N/m"),
            );
        }
    }
}

/// Closed form: statics of a cantilever under a force at its tip, `S_v = F`, `M_v = F (L - x)` and `F (x^2 L / 2 - x^3 / 6) / E
/// I`; all the power goes into the material.
#[test]
fn the_operating_state_of_a_cantilever_is_its_closed_form_at_a_low_frequency() {
    for length in [0.05, 0.5, 3.2] {
        let mut model = bare(length);
        model.supports.left = Support::CLAMPED;
        model.beam.material.loss_factor = 0.01;
        drive(&mut model, Place::Right, BeamMotion::V);
        let stiffness = constants(&model).bending_v;
        let state = operating(&Checked::new(model).unwrap(), 1e-4, 5);
        let (v, slope) = (BeamMotion::V as usize, BeamMotion::VSlope as usize);
        assert_eq!(state.positions.len(), 5);
        for (index, &x) in state.positions.iter().enumerate() {
            let case = format!("{length} m, {x}");
            let forces = state.forces.each_ref().map(|forces| forces[index]);
            assert_close(forces[v], 1.0, &case);
            if x < length {
                assert_close(forces[slope], length - x, &case);
            }
            if x > 0.0 {
                let expected = x * x * (length / 2.0 - x / 6.0);
                assert_close(state.motion[v][index] * stiffness, expected, &case);
            }
        }
        let input = state.power.inputs[0].power;
        assert_close(input.into(), state.power.material, "power");
    }
}

/// What holds a beam.
#[derive(Clone, Copy)]
enum HeldBy {
    /// Springs of 1e12 along all six motions of the left end.
    Stiff,
    /// Springs of 1e3 along w, psi and v of the left end, w and v of the right one.
    Soft,
    /// A foundation.
    Bedded,
}

/// What holds the beam, its length (m), the frequency (Hz), and the responses.
const BY_EXPONENTIAL: [(HeldBy, [f64; 2], [[f64; 2]; 6]); 15] = [
    (
        HeldBy::Stiff,
        [0.05, 0.001],
        [
            [1.000_000_000_000_045_6e-12, -4.538_324_207_848_462e-28],
            [1.000_000_000_000_031_5e-12, -3.134_506_407_261_341_3e-28],
            [1.000_000_000_000_043_4e-12, -4.315_685_328_503_964e-28],
            [1.059_952_560_982_840_7e-10, -1.048_582_611_724_818e-12],
            [8.630_601_495_255_805e-9, -8.620_108_564_600_612e-11],
            [1.582_827_199_149_386_5e-10, -1.570_948_158_058_911_6e-12],
        ],
    ),
    (
        HeldBy::Stiff,
        [0.05, 0.1],
        [
            [1.000_000_000_456_224_4e-12, -4.538_324_210_081_1e-24],
            [1.000_000_000_314_079_8e-12, -3.134_506_408_593_359e-24],
            [1.000_000_000_433_905_3e-12, -4.315_685_330_763_663e-24],
            [1.059_952_561_331_438_4e-10, -1.048_582_612_415_821_3e-12],
            [8.630_601_496_950_212e-9, -8.620_108_567_984_815e-11],
            [1.582_827_199_638_370_7e-10, -1.570_948_159_030_188_6e-12],
        ],
    ),
    (
        HeldBy::Stiff,
        [3.2, 0.001],
        [
            [1.000_000_022_360_667e-12, -1.989_725_619_371_932e-22],
            [1.000_000_018_000_209_2e-12, -1.605_194_984_470_567_7e-22],
            [1.000_000_018_564_681_2e-12, -1.654_847_181_904_485_2e-22],
            [2.212_523_730_950_976_6e-7, -1.860_290_943_919_516_6e-9],
            [6.616_131_277_580_721e-5, -5.866_211_220_029_734e-7],
            [2.937_097_447_459_667e-7, -2.591_359_561_084_090_2e-9],
        ],
    ),
    (
        HeldBy::Stiff,
        [3.2, 0.1],
        [
            [1.000_223_639_273_825_8e-12, -1.990_308_093_027_502_8e-18],
            [1.000_180_028_280_643_4e-12, -1.605_663_015_054_767_9e-18],
            [1.000_185_673_396_701_2e-12, -1.655_322_155_121_610_5e-18],
            [2.212_838_773_983_705_4e-7, -1.860_847_574_350_067_1e-9],
            [6.616_917_974_828_308e-5, -5.867_611_222_658_302e-7],
            [2.937_404_301_770_006_7e-7, -2.591_903_544_680_663_3e-9],
        ],
    ),
    (
        HeldBy::Stiff,
        [300.0, 0.001],
        [
            [1.001_441_471_464_871_7e-12, -1.064_680_594_115_310_8e-18],
            [1.000_316_335_351_845_7e-12, -1.483_523_490_126_772_8e-18],
            [1.001_451_561_977_036_3e-12, -9.685_765_884_232_454e-19],
            [0.002_436_799_474_396_065_7, 2.335_028_775_724_652_7e-6],
            [0.006_282_477_508_530_973, -5.587_119_811_756_905e-5],
            [0.002_522_493_521_374_547_5, 1.779_022_902_494_335_7e-6],
        ],
    ),
    (
        HeldBy::Soft,
        [0.05, 0.001],
        [
            [0.000_499_909_313_093_314_5, -3.058_974_765_592_822e-10],
            [0.001_000_000_019_357_816_8, -4.595_010_554_949_453_5e-17],
            [0.000_499_902_731_198_539_4, -2.470_900_456_738_448e-10],
            [0.000_500_090_787_911_697, 3.058_974_215_619_219e-10],
            [0.001_001_106_316_821_893_7, -9.886_071_879_303_628e-9],
            [0.000_500_097_367_666_320_4, 2.470_900_012_494_827e-10],
        ],
    ),
    (
        HeldBy::Soft,
        [0.05, 0.1],
        [
            [0.000_500_414_755_613_606_1, -3.062_058_823_332_768_7e-10],
            [0.001_000_193_696_876_861_7, -4.596_415_252_844_714e-13],
            [0.000_500_397_461_717_454_8, -2.473_390_401_919_019e-10],
            [0.000_500_596_224_560_266_1, 3.056_553_062_759_495_5e-10],
            [0.001_001_300_107_551_122_8, -9.887_544_326_524_222e-9],
            [0.000_500_592_093_542_284_1, 2.468_943_098_312_239_6e-10],
        ],
    ),
    (
        HeldBy::Soft,
        [3.2, 0.001],
        [
            [0.000_494_287_559_248_727_7, -1.928_290_625_096_545_7e-8],
            [0.001_000_001_259_652_272_3, -1.882_982_895_888_252_3e-13],
            [0.000_493_872_558_899_464, -1.557_585_319_065_595_2e-8],
            [0.000_505_718_929_941_793_2, 1.928_268_087_693_417_2e-8],
            [0.001_070_853_083_046_270_2, -6.329_991_627_427_009e-7],
            [0.000_506_133_788_546_503_3, 1.557_567_114_377_870_5e-8],
        ],
    ),
    (
        HeldBy::Soft,
        [3.2, 0.1],
        [
            [0.000_528_773_608_545_465_5, -2.063_426_863_176_281e-8],
            [0.001_013_115_836_079_622_8, -1.926_096_400_100_570_6e-9],
            [0.000_527_594_071_687_436_2, -1.666_753_959_090_612_8e-8],
            [0.000_540_179_728_056_601_3, 1.820_591_710_919_979_3e-8],
            [0.001_084_461_660_044_381_2, -6.394_315_922_936_939e-7],
            [0.000_539_835_824_860_794_2, 1.470_577_778_018_573_2e-8],
        ],
    ),
    (
        HeldBy::Soft,
        [300.0, 0.001],
        [
            [0.000_284_733_136_261_228_8, -7.482_062_611_727_864e-7],
            [0.001_000_306_249_653_983, -1.683_812_732_899_357e-9],
            [0.000_268_489_221_034_220_94, -6.043_669_327_770_657e-7],
            [0.000_716_100_997_003_269_3, 7.461_895_374_124_445e-7],
            [0.007_814_690_592_477_733, -6.036_669_314_019_416_5e-5],
            [0.000_732_288_303_246_679_4, 6.027_379_121_687_031e-7],
        ],
    ),
    (
        HeldBy::Bedded,
        [0.05, 0.001],
        [
            [0.000_199_891_065_141_863_8, -1.418_060_303_767_408e-7],
            [-0.037_675_224_091_272_53, -63.661_955_083_685_24],
            [6.003_878_115_424_505_5e-6, -1.838_268_246_914_345_9e-6],
            [0.000_200_108_798_964_303_74, -1.415_211_772_574_233_4e-7],
            [-0.037_674_703_561_119_34, -63.661_955_088_288_03],
            [6.226_460_122_016_205e-6, -1.838_454_285_804_688_6e-6],
        ],
    ),
    (
        HeldBy::Bedded,
        [0.05, 0.1],
        [
            [0.000_199_127_285_677_549, -1.412_245_371_587_760_9e-5],
            [-0.037_545_723_213_778_11, -0.634_412_295_324_138_5],
            [5.879_733_054_170_387e-6, -2.177_345_310_600_393_6e-6],
            [0.000_199_345_020_867_090_36, -1.412_216_885_675_671e-5],
            [-0.037_545_202_683_948_85, -0.634_412_299_927_000_7],
            [6.102_316_238_659_48e-6, -2.177_531_348_461_325_6e-6],
        ],
    ),
    (
        HeldBy::Bedded,
        [3.2, 0.001],
        [
            [-5.873_669_208_625_327e-7, -7.277_053_527_805_568e-9],
            [-0.000_601_061_572_825_265_7, -0.994_717_947_118_583],
            [-1.447_156_288_759_437e-7, 4.205_372_502_312_047e-8],
            [6.849_355_534_572_223e-6, 2.764_306_532_284_806e-9],
            [-0.000_565_230_924_701_584_8, -0.994_718_247_908_914_6],
            [3.514_344_762_479_094e-7, -9.974_524_234_579_114e-8],
        ],
    ),
    (
        HeldBy::Bedded,
        [3.2, 0.1],
        [
            [-6.000_930_907_967_523e-7, -2.260_927_857_750_977_7e-7],
            [-0.000_599_038_609_892_253_9, -0.009_912_580_657_651_904],
            [-1.466_720_594_558_920_4e-7, 3.674_068_671_765_088e-8],
            [6.838_213_738_871_525e-6, -2.153_149_734_213_466e-7],
            [-0.000_563_206_930_187_443_4, -0.009_912_903_546_548_02],
            [3.495_115_066_312_402e-7, -1.050_281_543_540_888_7e-7],
        ],
    ),
    (
        HeldBy::Bedded,
        [300.0, 0.001],
        [
            [4.740_368_606_552_534e-9, -5.838_658_243_781_982e-10],
            [-0.001_153_487_425_305_677_5, -0.010_512_752_070_088_545],
            [1.156_819_772_388_976e-10, -5.025_240_775_135_326e-11],
            [2.684_861_653_959_907e-6, 2.337_405_734_603_650_4e-9],
            [0.002_294_821_263_366_821, -0.010_730_616_205_303_753],
            [2.029_833_846_368_013_3e-7, -4.586_674_990_176_109_5e-8],
        ],
    ),
];

/// A beam of a length whose section has no symmetry, with a load and a response along w, psi and v.
fn without_symmetry(held: HeldBy, length: f64) -> Model {
    let mut model = bare(length);
    model.beam.theory = Theory::Timoshenko;
    model.beam.axial_force = 1e5;
    model.beam.material.loss_factor = 0.01;
    let section = &mut model.beam.section;
    (section.centroid_offset_y, section.product_moment) = (-0.05, 3e-5);
    (section.shear_area_y, section.shear_area_z) = (6e-3, 4e-3);
    let spring = |stiffness| {
        Restraint::Elastic(Elastic {
            spring: Spring {
                stiffness,
                ..Spring::default()
            },
            inertia: 0.0,
        })
    };
    let displacements = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V];
    match held {
        HeldBy::Stiff => {
            model.supports.left = Support::on_axis(BeamMotion::ALL.map(|_| spring(1e12)));
        }
        HeldBy::Soft => {
            for motion in displacements {
                model.supports.left[motion] = spring(1e3);
                if motion != BeamMotion::Psi {
                    model.supports.right[motion] = spring(1e3);
                }
            }
        }
        HeldBy::Bedded => {
            model.beam.foundation.w.stiffness = 1e5;
            model.beam.foundation.psi.damping = 50.0;
            model.beam.foundation.v.stiffness = 3e6;
            model.beam.foundation.v.loss_factor = 0.3;
        }
    }
    for motion in displacements {
        drive(&mut model, Place::Right, motion);
    }
    model.responses.clear();
    for place in [Place::Left, Place::Right] {
        for motion in displacements {
            let target = Target::Beam(place, motion);
            model.responses.push(Response {
                name: format!("R{}", model.responses.len()),
                enabled: true,
                point: Point::AXIS,
                quantity: Quantity::Motion(target, Measure::Displacement),
                over: None,
            });
        }
    }
    model
}

/// High-precision solution: the exponential of the state equation (Vlasov's beam with shear, rotary inertia and an axial
/// force) with 120 digits by mpmath, 1200 for 300 m, between both ends: w, psi and v at the left and at the right end under
/// unit loads along all three at the right end.
#[test]
fn beams_without_symmetry_respond_as_by_the_exponential_of_their_state_equation() {
    for (held, [length, frequency], expected) in BY_EXPONENTIAL {
        let model = without_symmetry(held, length);
        let found = respond(&model, frequency);
        for (found, [re, im]) in found.into_iter().zip(expected) {
            let expected = Complex64::new(re, im);
            let error = (found - expected).norm() / expected.norm();
            assert!(error < 1e-10, "{length} m, {frequency} Hz: {error:.1e}");
        }
    }
}

/// Expected: neither number loses more than 1e-11 where one takes over from the other.
#[test]
fn both_numbers_agree_where_one_takes_over() {
    for preset in presets::ALL {
        let plan = Plan::new(&read(preset.text).unwrap().into_inner());
        let limit = Prepared::new(plan.clone()).low_limit;
        let omegas = [1.01, 1.3, 2.0].map(|by| Complex64::from(by * limit));
        let [exact, fast] = [true, false].map(|is_low| solved(&plan, &omegas, is_low));
        let [exact, fast] = [exact, fast].map(|of| {
            let row = |row: usize| of.iter().map(move |values| values[row]);
            (0..omegas.len()).flat_map(row).collect::<Vec<_>>()
        });
        assert_near(&fast, &exact, plan.outputs.len(), [1e-11, 0.0, 1e-14]);
    }
}

/// Expected: the same model solved afresh.
#[test]
fn cached_sides_serve_low_frequencies_and_others() {
    let never = AtomicBool::new(false);
    let mut start = read(presets::find("fig13").unwrap().text)
        .unwrap()
        .into_inner();
    let pattern = start.subsystems[0].clone();
    for index in 0..12 {
        let mut subsystem = pattern.clone();
        subsystem.name = format!("T{index}");
        subsystem.position = start.beam.length * f64::from(index + 1) / 13.0;
        start.subsystems.push(subsystem);
    }
    let all: Vec<f64> = (0..40).map(|k| 1e-3 * 1.4_f64.powi(k)).collect();
    // The length moves the limit of what is low.
    let edits: [fn(&mut Model); 2] = [
        |model| model.subsystems[5].mass *= 1.1,
        |model| model.beam.length *= 1.01,
    ];
    for edit in edits {
        let (mut model, mut cache) = (start.clone(), SweepCache::default());
        for change in 0..4 {
            edit(&mut model);
            let model = Checked::new(model.clone()).unwrap();
            assert_eq!(cache.knows(&model, &all), change > 1);
            let expected = sweep(&model, &all, &never).unwrap();
            let found = cache.sweep(&model, &all, &never).unwrap();
            for (found, expected) in found.columns.iter().zip(&expected.columns) {
                for (row, (a, b)) in found.values.iter().zip(&expected.values).enumerate() {
                    let error = (a - b).norm() / b.norm();
                    let at = all[row];
                    assert!(error < 1e-10, "{}, {at} Hz: {error:.1e}", found.name);
                }
            }
        }
    }
}

/// Expected: the values with 50 digits by mpmath, as sums of two doubles.
#[test]
fn elementary_functions_have_twice_the_digits() {
    type Number = Real<DoubleDouble>;
    let sum = |parts: [f64; 2]| Number::splat(parts[0]) + Number::splat(parts[1]);
    let assert_near = |found: Number, expected: [f64; 2], of: f64| {
        let error = (found - sum(expected)).lanes()[0];
        assert!(error.abs() < 2e-31 * expected[0].abs(), "{error:e} of {of}");
    };
    let exact = [
        (
            1e-09,
            [3.162_277_660_168_379_5e-5, -9.946_806_139_223_485e-22],
            [1.000_000_001, -8.224_037_093_664_211e-17],
            [1e-09, -1.666_666_666_666_666_9e-28],
            [1.0, -5e-19],
        ),
        (
            -0.3,
            [0.547_722_557_505_166_1, 2.890_126_723_719_787e-17],
            [0.740_818_220_681_717_9, -1.805_530_505_953e-18],
            [-0.295_520_206_661_339_55, -1.831_535_727_679_253_6e-17],
            [0.955_336_489_125_606, 4.193_560_029_790_746_7e-17],
        ),
        (
            0.75,
            [0.866_025_403_784_438_6, 5.017_542_110_903_451_4e-17],
            [2.117_000_016_612_675, -1.157_100_624_944_023_4e-16],
            [0.681_638_760_023_334_1, 4.410_467_313_197_903e-17],
            [0.731_688_868_873_820_9, -1.047_582_430_651_276_8e-17],
        ),
        (
            -1.0,
            [1.0, 0.0],
            [0.367_879_441_171_442_33, -1.242_875_367_278_836_3e-17],
            [-0.841_470_984_807_896_5, -1.776_845_092_935_536e-18],
            [0.540_302_305_868_139_8, -4.760_954_612_604_417e-17],
        ),
        (
            2.4,
            [1.549_193_338_482_966_8, -8.314_995_870_284_978e-17],
            [11.023_176_380_641_601, -5.398_452_778_468_884e-16],
            [0.675_463_180_551_151, 3.748_141_318_708_627_4e-17],
            [-0.737_393_715_541_245_4, 2.886_220_706_633_374_7e-18],
        ),
        (
            -9.6,
            [3.098_386_676_965_933_6, -1.662_999_174_056_995_7e-16],
            [6.772_873_649_085_39e-5, -1.153_929_818_839_821_3e-21],
            [0.174_326_781_222_979_65, -1.344_062_860_870_013_5e-17],
            [-0.984_687_855_794_127, 1.520_973_881_201_662e-17],
        ),
        (
            17.3,
            [4.159_326_868_617_084, 2.639_578_915_401_275_5e-16],
            [32_605_775.720_995_87, -1.524_220_887_984_725_8e-9],
            [-0.999_774_431_073_011_1, -6.071_956_797_155_485e-18],
            [0.021_238_808_173_646_012, 5.095_958_310_502_079e-19],
        ),
        (
            -120.7,
            [10.986_355_173_577_815, -7.327_859_772_334_084e-16],
            [3.807_641_348_054_844_5e-53, -1.846_423_375_886_654_7e-69],
            [-0.968_585_709_920_344_5, 1.057_735_395_988_769_8e-17],
            [0.248_679_960_065_346_23, 7.876_677_408_530_537e-18],
        ),
        (
            -600.1,
            [24.496_938_584_239_462, -1.757_450_102_480_013_8e-15],
            [2.398_177_973_791_773e-261, 1.401_323_523_828_551e-277],
            [0.055_774_207_079_916_9, 1.476_986_573_774_674e-18],
            [-0.998_443_407_422_076_5, 3.944_529_635_705_502e-17],
        ),
    ];
    for (x, root, exponential, sine, cosine) in exact {
        let number = Number::splat(x);
        assert_near(number.abs().sqrt(), root, x);
        assert_near(number.exp(), exponential, x);
        let (found_sine, found_cosine) = number.sin_cos();
        assert_near(found_sine, sine, x);
        assert_near(found_cosine, cosine, x);
        let third = Number::ONE / Number::splat(3.0);
        let rest = third * Number::splat(3.0) - Number::ONE;
        assert!(rest.lanes()[0].abs() < 2e-32);
    }
}
