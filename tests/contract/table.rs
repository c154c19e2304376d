// The operations of motions: `operations.rs` says how they are written.
operations! {
    // Constructors and parts.
    identity(level l) -> motion, scale::of_a, [agrees(0.0, "constants")];
    from_rotation(rotation a) -> motion, scale::of_a, [takes_any("a copy"), agrees(0.0, "copies")];
    from_translation(vector v) -> motion, scale::of_v, [agrees(0.0, "a product with one half is exact")];
    from_rotation_translation(rotation a, vector v) -> motion, scale::of_v, [
        agrees(3.0, "fused products, and another order of summands"),
        digits("from_rotation_translation", &["r", "t"], of_digits::plain, &[
            within(4.0, "the rotation is normalized first")])];
    from_translation_rotation(vector v, rotation a) -> motion, scale::of_v, [
        agrees(3.0, "fused products, and another order of summands"),
        digits("from_translation_rotation", &["t", "r"], of_digits::plain, &[
            within(3.0, "the rotation is normalized first")])];
    mul_rotation_translation(any a, any_rotation b, vector v) -> motion, scale::times_rotation_translation, [
        agrees(8.0, "as mul; (q + ½pt)r in lanes, q·r + p·(½tr) in scalar"),
        digits("mul_rotation_translation", &["a", "r", "t"], of_digits::product_with_rotation, &[
            within(3.0, "half a product with a translation, and two with a rotation")])];
    from_matrix3x4(rows rows) -> unit, scale::of_rows, [
        agrees(7.0, "a quaternion normalized, a product with the translation"),
        digits_of_either_sign("from_matrix3x4", &["rows"], &[
            within(3.0, "rounded on the way in; divided by its largest sum, normalized, and a product")])];
    from_screw(screw screw) -> small_motion, scale::from_screw, [
        agrees(5.0, "sine and cosine are polynomials, where scalar asks the library"),
        digits("from_screw", &["l:3 m:3 angle:1 slide:1"], of_digits::from_screw, &[
            within(2.5, "a sine and a cosine; the axis is rounded on the way in")])];
    rotation(unit a) -> quat, scale::of_a, [agrees(0.0, "copies")];
    translation(unit a) -> point, scale::of_a, [
        agrees(11.0, "fused products, another order of summands, doubled"),
        digits("translation", &["a"], of_digits::plain, &[
            within(8.0, "normalized first; then sums of 4 products of q and p, doubled")])];
    to_matrix3x4(unit a) -> matrix3x4, scale::of_a, [
        agrees(11.0, "as translation; products are doubled at another step"),
        digits("matrix", &["a"], of_digits::plain, &[
            within(13.0, "normalized first; squares of p, doubled, and the translation")])];
    to_matrix4(unit a) -> matrix4, scale::of_a, [
        agrees(11.0, "as to_matrix3x4"),
        digits("to_matrix4", &["a"], of_digits::plain, &[within(13.0, "as matrix")])];
    to_screw(unit a) -> screw, scale::to_screw, [
        agrees(18.0, "the angle by a polynomial; slide and moment by a reciprocal length"),
        digits("screw", &["a"], of_digits::to_screw, &[
            within(17.0, "normalized first; the angle is up to π, so 1 ulp of it is 4 u")])];

    // The algebra of all dual quaternions.
    conjugate_dual(any a) -> motion, scale::of_a, [agrees(0.0, "signs"),
        digits("conj_dual", &["a"], of_digits::plain, &[within(0.0, "signs only")])];
    conjugate(any a) -> motion, scale::of_a, [agrees(0.0, "signs"),
        digits("conj_quat", &["a"], of_digits::plain, &[within(0.0, "signs only")])];
    conjugate_both(any a) -> motion, scale::of_a, [agrees(0.0, "signs"),
        digits("conj_both", &["a"], of_digits::plain, &[within(0.0, "signs only")])];
    canonical(any a) -> motion, scale::of_a, [agrees(0.0, "signs"),
        digits("canonical", &["a"], of_digits::plain, &[within(0.0, "signs only")])];
    scale(any a, real s) -> motion, scale::scaled, [agrees(0.0, "one product"),
        digits("scale", &["a", "factor"], of_digits::scaled, &[within(0.75, "one product")])];
    scale_dual(any a, dual s t) -> motion, scale::scaled_dual, [
        agrees(3.5, "a fused sum of two products"),
        digits("scale_dual", &["a", "factor"], of_digits::scaled, &[
            within(0.75, "a sum of two products, over the length of the factor")])];
    dot(any a, any b) -> dual, scale::product, [agrees(5.5, "fused sums of four products"),
        digits("dot", &["a", "b"], of_digits::product, &[
            within(0.75, "sums of 4 and 8 products, of which few are as large as the scale")])];
    norm(any a) -> dual, scale::of_a, [
        agrees(9.0, "scalar sums the squares of ratios to the largest component"),
        digits("norm", &["a"], of_digits::norm, &[
            within(2.0, "a sum of squares, half of whose error the root takes away")])];
    normalize(any a) -> unit, scale::quotient, [
        agrees(12.5, "another length; the part of q along p is a difference"),
        digits("normalize", &["a"], of_digits::plain, &[
            within(3.5, "norm, reciprocal, product, and the part of q along p")])];
    normalize_checked(any a) -> checked, scale::quotient, [agrees(12.5, "as normalize")];
    is_unit(unit a, real tolerance) -> mask, scale::one, [takes_any("it asks"), agrees(0.0, "a truth value")];
    inverse(any a) -> motion, scale::inverse, [
        agrees(32.0, "another length, which divides thrice around p*qp*"),
        digits("inverse", &["a"], of_digits::inverse, &[
            within(5.0, "two divisions by the norm, two quaternion products")])];
    inverse_checked(any a) -> checked, scale::inverse, [agrees(32.0, "as inverse")];
    abs_diff_eq(unit a, unit b, real tolerance) -> mask, scale::one, [takes_any("it compares numbers"), agrees(0.0, "a truth value")];
    add(any a, any b) -> motion, scale::sum, [agrees(0.0, "one sum"),
        digits("add", &["a", "b"], of_digits::sum, &[within(1.25, "one sum")])];
    sub(any a, any b) -> motion, scale::sum, [agrees(0.0, "one difference"),
        digits("sub", &["a", "b"], of_digits::sum, &[within(1.25, "one difference")])];
    mul(any a, any b) -> motion, scale::product, [
        agrees(8.0, "fused products, another order of summands"),
        digits("mul", &["a", "b"], of_digits::product, &[within(2.5, "sums of 4 and 8 products")])];
    neg(any a) -> motion, scale::of_a, [agrees(0.0, "signs")];

    // What motions do.
    transform_point(unit a, vector v) -> point, scale::point, [
        agrees(13.0, "rotation and translation in one sum, doubled at its end"),
        digits("point", &["a", "v"], of_digits::plain, &[within(14.0, "a vector and a translation")])];
    transform_vector(unit a, vector v) -> direction, scale::direction, [
        agrees(12.0, "fused products, doubled at another step"),
        digits("vector", &["a", "v"], of_digits::plain, &[
            within(12.0, "normalized first; an error of p counts twice on each side of v")])];
    transform_line(unit a, line v w) -> line, scale::line, [
        agrees(23.0, "two vectors and a product of a translation"),
        digits("line", &["a", "l:3 m:3"], of_digits::line, &[
            within(11.0, "three vectors and a product of a translation, over 1 + |l|")])];
    transform_plane(unit a, plane v s) -> plane, scale::plane, [
        agrees(22.0, "a vector and its product with a translation"),
        digits("transform_plane", &["a", "n:3 offset:1"], of_digits::plane, &[
            within(6.5, "a vector and its product with a translation, over 1 + |n|")])];

    // Blends.
    nlerp(unit a, unit b, real t) -> unit, scale::nlerp, [
        takes_any("the answer is normalized"),
        agrees(12.5, "a fused sum, then as normalize"),
        digits("nlerp", &["a", "b", "t"], of_digits::plain, &[within(3.0, "as dlb, of two")])];
    dlb(influences weights a b c) -> blend, scale::dlb, [
        takes_any("the answer is normalized"),
        agrees(12.5, "a fused sum, then as normalize"),
        digits_of_either_sign("dlb", &["s w"], &[within(4.0, "up to 4 poses normalized, summed, normalized")])];
    dlb_running(influences weights a b c d) -> blend, scale::poses, [
        takes_any("the answer is normalized"),
        double(Clusters, Either, &[within(4.5, "four poses summed and normalized")]),
        digits_of_either_sign("dlb_running", &["s w"], &[within(3.0, "as dlb, of four at most")])];
    dib(influences weights a b c d, settled tolerance, at_most iterations) -> mean, scale::poses, [
        double(Clusters, Either, &[
            within(13.0, "steps within 16 u are none; then a product and a mean of logs")]),
        digits_of_either_sign("dib", &["s w", "", ""], &[
            within(8.0, "the poses are rounded on the way in and normalized; then as above")])];
    slerp_lerp(unit a, unit b, real t) -> unit, scale::poses, [
        double(Clusters, Either, &[within(6.0, "two sines over a third, and two translations")]),
        digits("slerp_lerp", &["a", "b", "t"], of_digits::plain, &[
            within(6.0, "both ends normalized; a slerp, two translations and a product")])];
    squad(unit a, unit b, unit c, unit d, real t) -> unit, scale::poses, [
        double(Clusters, Either, &[within(7.5, "three screw interpolations")]),
        digits("squad", &["a", "b", "c", "d", "t"], of_digits::plain, &[
            within(5.5, "four ends normalized; three screw interpolations")])];
    squad_control(unit a, unit b, unit c) -> unit, scale::poses, [
        double(Clusters, Either, &[within(3.0, "two logarithms, an exponential and a product")]),
        digits("squad_control", &["a", "b", "c"], of_digits::plain, &[
            within(4.5, "three ends normalized; two logarithms, an exponential and a product")])];

    // Screws.
    log(unit a) -> log, scale::log, [
        agrees(14.0, "a factor that is a polynomial in y, where scalar has axis and atan2"),
        digits("log", &["a"], of_digits::plain, &[
            on(SMALL, 4.0, "no cancellation: the vector part keeps its relative precision"),
            within(6.0, "normalized first; then one factor that varies slowly")])];
    exp(dual_vector v w) -> small_motion, scale::exp, [
        agrees(6.0, "sine and cosine are polynomials, where scalar asks the library"),
        digits("exp", &["v:3 m:3"], of_digits::plain, &[
            within(2.5, "even functions of the square, one product")])];
    pow(unit a, real t) -> small_motion, scale::pow, [
        agrees(17.0, "as log, times t, as exp"),
        digits_of_either_sign("pow", &["a", "t"], &[
            on(SMALL, 4.0, "no cancellation: the vector part keeps its relative precision"),
            within(6.0, "normalized first; log, times t, exp")])];
    sqrt(unit a) -> small_motion, scale::sqrt, [
        agrees(5.5, "by the book a log and an exp, else cos(Θ/2) and the vector part over 2 cos(Θ/2)"),
        digits_of_either_sign("sqrt", &["a"], &[
            on(SMALL, 1.5, "no cancellation: the vector part keeps its relative precision"),
            within(3.0, "normalized first; one root, or, by the book, half a screw")])];
    sclerp(unit a, unit b, real t) -> unit, scale::sclerp, [
        agrees(8.5, "slerp about the middle in lanes, a(a*b)ᵗ in scalar"),
        digits_of_either_sign("sclerp", &["a", "b", "t"], &[
            on(SMALL, 5.0, "both ends normalized; slerp about their middle"),
            within(8.0, "both ends normalized; the scalar reference has two more products")])];
    sclerp_long(unit a, unit b, real t) -> unit, scale::sclerp_long, [
        agrees(10.5, "as sclerp; the scale already holds how near the antipode is"),
        digits("sclerp_long", &["a", "b", "t"], of_digits::sclerp_long, &[
            on(&["opposite"], 2.0, "the scale holds how near the antipode is"),
            within(4.5, "as sclerp")])];

    // Distances.
    angle_to(unit a, unit b) -> angle, scale::apart, [double(Clusters, Kept, &[
        within(2.5, "a product of rotations, whose vector part cancels; twice an arctangent of it")]),
        digits("angle_to", &["a", "b"], of_digits::angle, &[
            within(8.5, "both ends normalized; a product and twice an arctangent, relative to small turns")])];
    distance_to(unit a, unit b) -> length, scale::apart, [double(Clusters, Kept, &[
        within(7.5, "two translations of 8 products each")]),
        digits("distance_to", &["a", "b"], of_digits::plain, &[
            within(7.5, "both ends normalized; two translations")])];
    distance_weighted(unit a, unit b, real s) -> length, scale::apart, [double(Clusters, Kept, &[
        within(9.0, "an angle, a distance and a root")]),
        digits("distance_weighted", &["a", "b", "length_per_radian"], of_digits::weighted, &[
            within(6.5, "an angle, a distance and a root")])];
    point_error(unit a, unit b, vector v) -> length, scale::points_apart, [double(Clusters, Kept, &[
        within(7.0, "two points of 14 u each at worst, but over |t| + |v|")]),
        digits("point_error", &["a", "b", "v"], of_digits::plain, &[
            within(9.0, "both ends normalized; two points")])];
    shell_error(unit a, unit b, real radius) -> length, scale::points_apart, [double(Clusters, Kept, &[
        within(6.0, "as point_error")]),
        digits("shell_error", &["a", "b", "radius"], of_digits::shell, &[
            within(7.5, "an angle, its sine, and a distance")])];
    needs_renormalization(any a, real tolerance) -> mask, scale::one, [agrees(0.0, "a truth value")];

    // Velocities.
    derivative_spatial(unit a, twist x) -> motion, scale::derivative, [
        takes_any("linear in the motion"),
        double(Twists, Kept, &[within(5.0, "sums of 3 and 7 products")]),
        digits("derivative_spatial", &["a", "angular:3 linear:3"], of_digits::derivative, &[
            within(2.0, "normalized first; sums of 3 and 7 products")])];
    derivative_body(unit a, twist x) -> motion, scale::derivative, [
        takes_any("linear in the motion"),
        double(Twists, Kept, &[within(3.0, "sums of 3 and 7 products")]),
        digits("derivative_body", &["a", "angular:3 linear:3"], of_digits::derivative, &[
            within(1.5, "normalized first; sums of 3 and 7 products")])];
    spatial_twist(unit a, any derivative) -> twist, scale::twist_of_derivative, [
        double(Twists, Kept, &[within(4.5, "sums of 4 and 8 products")]),
        digits("spatial_twist", &["a", "derivative"], of_digits::twist_of_derivative, &[
            within(3.0, "normalized first; sums of 4 and 8 products")])];
    body_twist(unit a, any derivative) -> twist, scale::twist_of_derivative, [
        double(Twists, Kept, &[within(4.5, "sums of 4 and 8 products")]),
        digits("body_twist", &["a", "derivative"], of_digits::twist_of_derivative, &[
            within(4.0, "normalized first; sums of 4 and 8 products")])];
    derivative_from_velocity(unit a, angular w x, linear v x) -> motion, scale::derivative, [
        double(Twists, Kept, &[within(5.0, "a translation and two products")]),
        digits("derivative_from_velocity", &["a", "angular", "linear"], of_digits::derivative, &[
            within(3.5, "normalized first; a translation and two products")])];
    velocity(unit a, any derivative) -> velocity, scale::velocity, [
        double(Twists, Kept, &[within(5.5, "lanes go through the spatial twist")]),
        digits("velocity", &["a", "derivative"], of_digits::twist_of_derivative, &[
            within(5.0, "normalized first; lanes go through the spatial twist")])];
    from_twist(twist x) -> unit, scale::from_twist, [
        double(Twists, Kept, &[within(2.0, "exp of the half")]),
        digits("from_twist", &["angular:3 linear:3"], of_digits::from_twist, &[
            within(1.0, "exp of the half")])];
    to_twist(unit a) -> twist, scale::to_twist, [
        double(Twists, Kept, &[within(18.0, "twice a log; turns are up to π, so 1 ulp of one is 4 u")]),
        digits("to_twist", &["a"], of_digits::plain, &[
            on(SMALL, 2.5, "no cancellation: the vector part keeps its relative precision"),
            within(14.0, "normalized first; twice a log, up to π")])];
    twist_to(unit a, unit b) -> twist, scale::apart, [
        double(Clusters, Kept, &[within(13.0, "a product, and twice a log, over π and the lengths")]),
        digits("twist_to", &["a", "b"], of_digits::plain, &[
            within(9.0, "both ends normalized; a product, and twice a log")])];
    integrate_spatial(unit a, twist x, real dt) -> unit, scale::integrate, [
        takes_any("linear in the motion"),
        double(Twists, Kept, &[within(3.5, "exp and a product")]),
        digits("integrate_spatial", &["a", "angular:3 linear:3", "dt"], of_digits::integrate, &[
            within(4.0, "normalized first; exp and a product")])];
    integrate_body(unit a, twist x, real dt) -> unit, scale::integrate, [
        takes_any("linear in the motion"),
        double(Twists, Kept, &[within(3.0, "exp and a product")]),
        digits("integrate_body", &["a", "angular:3 linear:3", "dt"], of_digits::integrate, &[
            within(3.0, "normalized first; exp and a product")])];
    adjoint(unit a, twist x) -> twist, scale::adjoint, [
        double(Twists, Kept, &[within(8.5, "two turns and a product of the translation")]),
        digits("adjoint", &["a", "angular:3 linear:3"], of_digits::derivative, &[
            within(9.0, "normalized first; two turns and a product of the translation")])];
    coadjoint(unit a, wrench wrench) -> wrench, scale::coadjoint, [
        double(Twists, Kept, &[within(6.5, "two turns and a product of the translation")]),
        digits("coadjoint", &["a", "force:3 torque:3"], of_digits::coadjoint, &[
            within(12.0, "normalized first; two turns and a product of the translation")])];
    left_jacobian(twist x, twist y) -> twist, scale::jacobian, [
        double(Twists, Kept, &[within(2.5, "two dual cross products, coefficients of a few u")]),
        digits("left_jacobian",
            &["angular:3 linear:3", "along_angular:3 along_linear:3"], of_digits::jacobian, &[
            within(1.5, "two dual cross products, coefficients of a few u")])];
    right_jacobian(twist x, twist y) -> twist, scale::jacobian, [
        double(Twists, Kept, &[within(3.0, "as the left one")]),
        digits("right_jacobian",
            &["angular:3 linear:3", "along_angular:3 along_linear:3"], of_digits::jacobian, &[
            within(1.5, "as the left one")])];
    left_jacobian_inverse(twist x, twist y) -> twist, scale::jacobian_inverse, [
        double(Turns, Kept, &[within(4.0, "grows towards |ω| = 2π, which the scale takes out")]),
        digits("left_jacobian_inverse",
            &["angular:3 linear:3", "along_angular:3 along_linear:3"], of_digits::jacobian_inverse, &[
            within(2.0, "grows towards |ω| = 2π, which the scale takes out")])];
    right_jacobian_inverse(twist x, twist y) -> twist, scale::jacobian_inverse, [
        double(Turns, Kept, &[within(3.5, "as the left one")]),
        digits("right_jacobian_inverse",
            &["angular:3 linear:3", "along_angular:3 along_linear:3"], of_digits::jacobian_inverse, &[
            within(2.5, "as the left one")])];
}
