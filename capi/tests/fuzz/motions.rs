//! Functions on one motion.

use crate::random::Fuzz;
use dq8_capi::Status;
use dq8_capi::geometry::single as g;
use dq8_capi::mean::single::mean;
use dq8_capi::motion::single as m;
use dq8_capi::screw::single as s;

/// Functions on one motion; the output may lie on the input.
pub(crate) fn motions(fuzz: &mut Fuzz) {
    let (a, b, t) = (fuzz.numbers(8), fuzz.numbers(8), fuzz.number());
    let (three, matrix) = (fuzz.numbers(3), fuzz.numbers(16));
    let (most, mut converged) = (fuzz.below(9) as u32, -1);
    let (a, b, three, matrix) = (a.as_ptr(), b.as_ptr(), three.as_ptr(), matrix.as_ptr());
    let mut out = [8, 3, 12, 16, 8, 4, 6, 1].map(|count| fuzz.numbers(count));
    let [o8, o3, o12, o16, screw, o4, o6, o1] = out.each_mut().map(|out| out.as_mut_ptr());
    // SAFETY: every array has the length that its function says, and outputs lie apart.
    unsafe {
        for status in [
            m::mul(a, b, o8),
            m::mul(o8, o8, o8),
            m::conjugate(a, o8),
            m::point(a, three, o3),
            m::vector(a, three, o3),
            m::to_matrix_3x4(a, o12),
            m::to_matrix_4x4(a, o16),
            m::to_rotation_translation(a, o4, o3),
            g::line(a, b, o6),
            g::plane(a, b, o4),
            g::twist(a, b, o6),
            g::to_twist(a, o6),
            g::integrate_body(a, b, t, o8),
            g::angle_to(a, b, o1),
            g::distance_to(a, b, o1),
        ] {
            assert_eq!(status, Status::Ok);
        }
        // These refuse what has no answer.
        let _ = s::nlerp(a, b, t, o8);
        let _ = s::sclerp(a, b, t, o8);
        let _ = s::pow(a, t, o8);
        let _ = s::to_screw(a, screw);
        let _ = s::from_screw(screw, o8);
        let _ = m::inverse(a, o8);
        let _ = m::normalize(a, o8);
        let _ = m::check_unit(a, t);
        let done = mean(matrix, three, 2, t, most, o8, &raw mut converged);
        assert_eq!(converged == -1, done == Status::NotNormalizable, "{done:?}");
        let _ = m::from_matrix_4x4(matrix, t, o8);
        let _ = m::from_matrix_3x4(matrix, t, o8);
        assert_eq!(m::mul(a, std::ptr::null(), o8), Status::NullPointer);
    }
}
