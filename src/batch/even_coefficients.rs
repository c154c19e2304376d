//! Coefficients of the even functions, lowest degree first, for polynomials of dual numbers.
//!
//! The program `scripts/fit_even.py` writes this file and says how the coefficients are found. To
//! change them, edit the program and run `pip install mpmath && python3 scripts/fit_even.py`. With
//! `--check` the program compares this file with its own result and writes nothing.

/// Coefficients of a polynomial of degree 10 for arcsin(√c/2)/(√c/2) on [0, 2]. The relative
/// error of the fit is 1.3e-10, and that of its derivative is 3.0e-8.
pub(crate) const ARC_F32: [f32; 11] = [
    1.0, 0.041666668, 0.0046874974, 0.0006973995, 0.00011976366, 1.851719e-5, 9.754217e-6,
    -4.508163e-6, 3.2645512e-6, -9.586564e-7, 1.5363922e-7,
];

/// Coefficients of a polynomial of degree 21 for arcsin(√c/2)/(√c/2) on [0, 2]. The relative
/// error of the fit is 1.5e-19, and that of its derivative is 7.2e-17.
pub(crate) const ARC_F64: [f64; 22] = [
    1.0, 0.041666666666666664, 0.0046874999999998385, 0.0006975446428715162, 0.00011867947011363288,
    2.1847816578854793e-5, 4.236474082503778e-6, 8.525704903297111e-7, 1.7538796935820563e-7,
    3.978162965570708e-8, 2.4199503792349515e-9, 1.1184631870647248e-8, -1.2065559240171388e-8,
    1.2961002778096785e-8, -1.0434480742199005e-8, 6.639577116437372e-9, -3.2571812455081765e-9,
    1.2146188830758708e-9, -3.3261122201783866e-10, 6.333662887842426e-11, -7.513205035115344e-12,
    4.2339066102943327e-13,
];

/// Coefficients of a polynomial of degree 5 for sin(√v)/√v on [0, 1.02·(π/2)²]. The relative
/// error of the fit is 1.6e-9, and that of its derivative is 3.0e-8.
pub(crate) const SINC_F32: [f32; 6] = [
    1.0, -0.16666667, 0.008333357, -0.00019843988, 2.7665974e-6, -2.6037242e-8,
];

/// Coefficients of a polynomial of degree 8 for sin(√v)/√v on [0, 1.02·(π/2)²]. The relative
/// error of the fit is 1.0e-18, and that of its derivative is 5.6e-17.
pub(crate) const SINC_F64: [f64; 9] = [
    1.0, -0.16666666666666666, 0.008333333333333177, -0.00019841269841194888, 2.7557319207772606e-6,
    -2.5052106510118474e-8, 1.6058919702950807e-10, -7.642442323747389e-13, 2.7152197292868343e-15,
];

/// Coefficients of a polynomial of degree 5 for cos(√v) on [0, 1.02·(π/2)²]. The absolute
/// error of the fit is 8.5e-10, and that of its derivative is 2.8e-9.
pub(crate) const COS_F32: [f32; 6] = [
    1.0, -0.5, 0.04166665, -0.0013888445, 2.4761754e-5, -2.6048923e-7,
];

/// Coefficients of a polynomial of degree 8 for cos(√v) on [0, 1.02·(π/2)²]. The absolute
/// error of the fit is 1.4e-17, and that of its derivative is 7.4e-17.
pub(crate) const COS_F64: [f64; 9] = [
    1.0, -0.5, 0.04166666666666548, -0.0013888888888809023, 2.4801587281103704e-5,
    -2.755731656275405e-7, 2.0876564127696465e-9, -1.1462832814334701e-11, 4.6071772912976395e-14,
];

/// Coefficients of a polynomial of degree 6 for (√u − sin √u)/√u³ on [0, 1.02·π²]. The
/// relative error of the fit is 5.0e-8, and that of its derivative is 5.2e-8.
pub(crate) const LEFT_F32: [f32; 7] = [
    0.16666667, -0.008333334, 0.00019841346, -2.7560768e-6, 2.5115504e-8, -1.6548536e-10,
    8.662236e-13,
];

/// Coefficients of a polynomial of degree 10 for (√u − sin √u)/√u³ on [0, 1.02·π²]. The
/// relative error of the fit is 9.2e-17, and that of its derivative is 1.4e-17.
pub(crate) const LEFT_F64: [f64; 11] = [
    0.16666666666666666, -0.008333333333333333, 0.00019841269841269776, -2.7557319223975097e-6,
    2.505210838461187e-8, -1.6059043801349862e-10, 7.647162810254342e-13, -2.8114420831681043e-15,
    8.219040341302473e-18, -1.9468815937378392e-20, 3.480822515228739e-23,
];

/// Coefficients of a polynomial of degree 8 for (1 − (√u/2) cot(√u/2))/u on [0, 1.02·π²].
/// The relative error of the fit is 3.0e-8, and that of its derivative is 2.4e-8.
pub(crate) const INVERSE_F32: [f32; 9] = [
    0.083333336, 0.0013888889, 3.3068765e-5, 8.266628e-7, 2.0935323e-8, 5.0580645e-10,
    1.7742289e-11, -9.8647226e-14, 2.9000758e-14,
];

/// Coefficients of a polynomial of degree 16 for (1 − (√u/2) cot(√u/2))/u on [0, 1.02·π²].
/// The relative error of the fit is 5.6e-17, and that of its derivative is 3.8e-17.
pub(crate) const INVERSE_F64: [f64; 17] = [
    0.08333333333333333, 0.001388888888888889, 3.306878306878304e-5, 8.267195767179155e-7,
    2.0876756994266455e-8, 5.284190030192656e-10, 1.3382547195598795e-11, 3.3896123776295247e-13,
    8.589036530320869e-15, 2.165595036335202e-16, 5.718770650458383e-18, 1.0488466804725875e-19,
    7.697497667559382e-21, -2.669690089767222e-22, 2.315730278065806e-23, -7.113583952919036e-25,
    1.5812548369152405e-26,
];
