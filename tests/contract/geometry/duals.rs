//! Functions of dual numbers: every error is relative to the number itself, unless that is a sum.

geometry! { duals:
    "Dual::mul"(a: dual, b: dual) -> dual, product, [
        within(1.5, "a sum of two products")],
        plain a * b;
    "Dual::div"(a: dual, b: dual) -> dual, quotient, [
        within(2.5, "a quotient, and one of a difference with it")],
        plain a / b;
    "Dual::recip"(a: dual) -> dual, relative, [
        within(4.5, "a quotient, and twice a product with it")],
        plain a.recip();
    "Dual::inverse"(a: dual) -> dual, relative, [
        within(3.0, "as recip")],
        tried a.inverse(), a.inverse_checked();
    "Dual::powi"(a: dual, n: integer) -> dual, relative, [
        within(11.0, "five products at most, and the error of a square counts twice in the next")],
        plain a.powi(n);
    "Dual::sqrt"(a: dual) -> dual, relative, [
        within(3.0, "a root and a quotient by it")],
        plain a.sqrt();
    "Dual::sin"(a: dual) -> dual, relative, [
        within(2.3, "a sine, a cosine and a product")],
        plain a.sin();
    "Dual::cos"(a: dual) -> dual, relative, [
        within(4.3, "a cosine and a sine after many turns; a product")],
        plain a.cos();
    "Dual::tan"(a: dual) -> dual, relative, [
        within(4.8, "a quotient of sine and cosine, and its square")],
        plain a.tan();
    "Dual::asin"(a: dual) -> dual, relative, [
        within(2.8, "1 − a² as a product, its root, a quotient")],
        plain a.asin();
    "Dual::acos"(a: dual) -> dual, relative, [
        within(2.8, "as asin")],
        plain a.acos();
    "Dual::atan"(a: dual) -> dual, relative, [
        within(3.5, "a square, a sum and two quotients")],
        plain a.atan();
    "Dual::atan2"(a: dual, b: dual) -> dual, atan2, [
        within(3.2, "two quotients by the larger, a difference, two quotients")],
        plain a.atan2(b);
    "Dual::exp"(a: dual) -> dual, relative, [
        within(2.8, "an exponential and a product")],
        plain a.exp();
    "Dual::ln"(a: dual) -> dual, relative, [
        within(2.7, "a logarithm; a quotient")],
        plain a.ln();
}
