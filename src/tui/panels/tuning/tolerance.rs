//! The effect of the variables' tolerances on the curves: the band of most of them.

use std::sync::Arc;

use num_complex::Complex64;

use crate::solve::Reference;
use crate::tui::app::{App, Member, Trace};
use crate::worker::{Request, SpreadAnswer, SpreadRequest};

/// The fewest and the most frequencies of a band.
const POINTS: usize = 600;

impl App {
    /// Shows or hides the band.
    pub(crate) fn turn_tolerances(&mut self) {
        let tolerances = &mut self.tuning.tolerances;
        tolerances.shown = !tolerances.shown;
        if !tolerances.shown {
            tolerances.curves = None;
            tolerances.asked.forget();
            return self.done("tolerance band hidden");
        }
        if !has_tolerances(self) {
            self.tuning.tolerances.shown = false;
            return self.refuse(
                "no variable of [tune] has a tolerance: +-5 % behind its bounds gives it one",
            );
        }
        self.done("the band contains nine of ten curves within the tolerances");
    }

    /// Requests the band, once the curves are resolved.
    pub(crate) fn want_tolerances(&mut self) -> Option<Request> {
        let generation = self.curves.generation;
        let asked = &self.tuning.tolerances.asked;
        let known = asked.is(|asked| *asked == generation);
        if !self.tuning.tolerances.shown
            || known
            || !self.curves.is_resolved()
            || !has_tolerances(self)
        {
            return None;
        }
        let frequencies = &self.curves.picture()?.members.first()?.frequencies;
        let stride = frequencies.len().div_ceil(POINTS).max(1);
        let frequencies = frequencies.iter().copied().step_by(stride).collect();
        let serial = self.requests.next_serial();
        self.tuning.tolerances.asked.sent(serial, generation);
        Some(Request::Spread(SpreadRequest {
            serial,
            model: Arc::clone(self.document.model()),
            frequencies,
        }))
    }

    /// Stores the band of the last request.
    pub(crate) fn take_tolerances(&mut self, answer: SpreadAnswer) {
        let tolerances = &mut self.tuning.tolerances;
        let Some(&generation) = tolerances.asked.answered(answer.serial) else {
            return;
        };
        // Responses and forces are those of the current model.
        if generation != self.curves.generation {
            return;
        }
        let spread = match answer.result {
            Ok(spread) => spread,
            Err(reason) => return self.refuse(format!("no tolerance band: {reason}")),
        };
        let divisor =
            Reference::of(self.document.model()).map_or(1.0, |force| force.amplitude.norm());
        let Some((member, _)) = self.curves.first_trace() else {
            return;
        };
        let traces = |of: &dyn Fn(usize) -> Vec<f64>| -> Vec<Trace> {
            let traces = member.traces.iter().enumerate();
            traces
                .map(|(index, trace)| {
                    let by = trace.dimension.map_or(1.0, |_| divisor);
                    Trace {
                        response: trace.response.clone(),
                        dimension: trace.dimension,
                        force: trace.force,
                        values: of(index)
                            .iter()
                            .map(|one| Complex64::from(one / by))
                            .collect(),
                        peaks: Vec::new(),
                    }
                })
                .collect()
        };
        let curve = |of: &dyn Fn(usize) -> Vec<f64>| Member {
            label: None,
            frequencies: answer.frequencies.clone(),
            traces: traces(of),
            damping_ratios: Vec::new(),
        };
        if spread.len() != member.traces.len() {
            return;
        }
        let curves = [
            curve(&|index| spread[index].low.clone()),
            curve(&|index| spread[index].median.clone()),
            curve(&|index| spread[index].high.clone()),
        ];
        self.tuning.tolerances.curves = Some((generation, curves));
    }
}

/// Whether some variable of the model has a tolerance.
fn has_tolerances(app: &App) -> bool {
    let mut variables = app.model().tune.iter().flat_map(|tune| &tune.variables);
    variables.any(|variable| variable.tolerance > 0.0)
}
