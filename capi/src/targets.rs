//! Inverse kinematics of many configurations of a mechanism, on lanes.

use crate::mechanism::Mechanism;
use crate::reach::{
    Answer, Asked, Goal, ReachOptions, ReachReport, Search, Width, reach as search,
    reach_scratch as scratch,
};
use crate::status::Status;

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// How many numbers `scratch` of dq8_reach must have for so many goals, whatever the
            /// number of targets; for one mechanism always the same. DQ8_STATUS_TOO_LARGE for more
            /// than 1024 goals.
            reach_scratch(
                mechanism: *const Mechanism<$R>, goal_count: usize, scratch_count: *mut usize,
            ) = scratch(mechanism, goal_count, scratch_count, Width::Lanes)
        }
        export_one! { $R
            /// dq8_mechanism_reach for `count` configurations, as many at a time as there are
            /// lanes: `targets` are `[configuration][goal]`, `values`, `value_count` in all,
            /// `[configuration][value]`, and there is a report for each. Goals, posture and options
            /// are the same for all.
            ///
            /// The result of one does not depend on the others: threads may each have a part of the
            /// configurations, with scratch of their own, as many numbers as dq8_reach_scratch
            /// says. Errors are those of dq8_mechanism_reach.
            reach(
                mechanism: *const Mechanism<$R>, goals: *const Goal<$R>, goal_count: usize,
                targets: *const $R, posture: *const $R, options: *const ReachOptions<$R>,
                values: *mut $R, value_count: usize, scratch: *mut $R, scratch_count: usize,
                reports: *mut ReachReport<$R>, count: usize,
            ) = search(
                Asked { mechanism, goals, targets, goal_count, posture, options },
                Answer { values, value_count, scratch, scratch_count, reports, count },
                Width::Lanes,
                |search| {
                    let Search { reach, targets, values, scratch, reports, options } = search;
                    reach.job().solve_in(scratch, targets, values, reports, &options)
                },
            )
        }
    };
}
for_both_numbers!(functions);
