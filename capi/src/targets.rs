//! Inverse kinematics of many configurations of a mechanism, on lanes.

use crate::mechanism::Mechanism;
use crate::reach::{
    Goal, Query, ReachOptions, ReachReport, Results, Search, Width, reach as search,
    reach_scratch as scratch,
};
use crate::status::Status;

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Writes the size that `scratch` of dq8_reach must have. The size counts floats or
            /// doubles. It depends on the mechanism and the number of goals, and not on the number
            /// of configurations. Returns DQ8_STATUS_TOO_LARGE if there are more than 1024 goals.
            reach_scratch(
                mechanism: *const Mechanism<$R>, goal_count: usize, scratch_count: *mut usize,
            ) = scratch(mechanism, goal_count, scratch_count, Width::Lanes)
        }
        export_one! { $R
            /// Solves the inverse kinematics of `count` configurations. It computes several
            /// configurations at a time on lanes, and each like dq8_mechanism_reach. `targets` is
            /// `[configuration][goal]`. `values` is `[configuration][value]` and holds
            /// `value_count` values altogether. `reports` holds one report per configuration.
            /// Goals, posture and options are the same for all configurations.
            ///
            /// The result of a configuration does not depend on other configurations, so each
            /// thread may compute a part of them. Each thread needs scratch of its own, of the size
            /// that dq8_reach_scratch writes. Errors are those of dq8_mechanism_reach.
            reach(
                mechanism: *const Mechanism<$R>, goals: *const Goal<$R>, goal_count: usize,
                targets: *const $R, posture: *const $R, options: *const ReachOptions<$R>,
                values: *mut $R, value_count: usize, scratch: *mut $R, scratch_count: usize,
                reports: *mut ReachReport<$R>, count: usize,
            ) = search(
                Query { mechanism, goals, targets, goal_count, posture, options },
                Results { values, value_count, scratch, scratch_count, reports, count },
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
