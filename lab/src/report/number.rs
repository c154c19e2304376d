/// 10 to a power, written with superscripts: 10⁻⁶.
pub fn power_of_ten(exponent: i32) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| digits[digit as usize]);
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}

/// Two digits and a power of ten: 1.2·10⁻⁶; 0, ∞, and – for NaN.
pub fn scientific(value: f64) -> String {
    if value.is_nan() {
        return "–".to_owned();
    }
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{value:.1e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    with_minus(&format!("{mantissa}·{}", power_of_ten(exponent.parse().unwrap_or(0))))
}

/// With three decimals where that shows it, else [`scientific`].
pub fn decimal(value: f64) -> String {
    if (0.01..1000.0).contains(&value.abs()) {
        with_minus(&format!("{value:.3}"))
    } else {
        scientific(value)
    }
}

/// A minus instead of a hyphen.
fn with_minus(number: &str) -> String {
    number.replace('-', "−")
}
