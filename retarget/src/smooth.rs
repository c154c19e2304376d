//! Two-sided smoothing: a filter over time, which does not lag, and speeds that are not exceeded.

/// Replaces each column of `[frame][column]` by the x with the least |x − y|² + λ |x‴|²,
/// where x‴ are third differences. That is a filter of sixth order without a lag, which halves a
/// motion of the frequency 1 / (2π λ^(1/6)) frames. The result is that of one symmetric banded
/// system. It is solved in double precision: λ may be so large that single floats would lose the 1
/// beside it, and with it the values themselves.
pub(crate) fn smooth(values: &mut [f32], columns: usize, lambda: f64) {
    let frames = values.len() / columns.max(1);
    if frames < 4 {
        return;
    }
    let factors = factors(frames, lambda);
    let mut smooth: Vec<f64> = values.iter().copied().map(f64::from).collect();
    for row in 0..frames {
        let (done, later) = smooth.split_at_mut((row + 1) * columns);
        let now = &done[row * columns..];
        for (next, factor) in later.chunks_exact_mut(columns).zip(&factors[row][1..]) {
            next.iter_mut().zip(now).for_each(|(next, now)| *next -= factor * now);
        }
    }
    for row in (0..frames).rev() {
        let (now, later) = smooth[row * columns..].split_at_mut(columns);
        now.iter_mut().for_each(|now| *now *= factors[row][0]);
        for (next, factor) in later.chunks_exact(columns).zip(&factors[row][1..]) {
            now.iter_mut().zip(next).for_each(|(now, next)| *now -= factor * next);
        }
    }
    values.iter_mut().zip(smooth).for_each(|(value, smooth)| *value = smooth as f32);
}

/// Returns the factors L D Lᵀ of 1 + λ D₃ᵀ D₃: for each row one over its pivot, and the
/// three entries of L below it.
fn factors(frames: usize, lambda: f64) -> Vec<[f64; 4]> {
    const THIRD: [f64; 4] = [-1.0, 3.0, -3.0, 1.0];
    let mut band = vec![[1.0, 0.0, 0.0, 0.0]; frames];
    for row in 0..frames - 3 {
        for i in 0..4 {
            for j in i..4 {
                band[row + i][j - i] += lambda * THIRD[i] * THIRD[j];
            }
        }
    }
    for row in 0..frames {
        let [pivot, rest @ ..] = band[row];
        for i in 1..4.min(frames - row) {
            for j in i..4.min(frames - row) {
                band[row + i][j - i] -= rest[i - 1] * rest[j - 1] / pivot;
            }
        }
    }
    let factor = |[pivot, a, b, c]: [f64; 4]| [1.0 / pivot, a / pivot, b / pivot, c / pivot];
    band.into_iter().map(factor).collect()
}

/// The slowest motion that [`smooth`] may halve, in rounds per frame. Beyond it λ has more digits
/// than a double float.
pub(crate) const SLOWEST: f64 = 0.003;

/// Returns the λ of [`smooth`] that halves motions of this frequency in Hz.
pub(crate) fn lambda(frequency: f64, step: f64) -> f64 {
    (core::f64::consts::TAU * frequency * step).powi(-6)
}

/// Bounds the change of a column of `[frame][column]` from frame to frame, and changes it as little
/// on one side of a quick motion as on the other: the mean of a run forward and a run backward,
/// both of which keep the bound, keeps it as well.
pub(crate) fn slow_down(values: &mut [f32], columns: usize, column: usize, most: f32) {
    let mut forward: Vec<f32> = values.iter().skip(column).step_by(columns).copied().collect();
    let bound = |course: &mut [f32], order: &mut dyn Iterator<Item = (usize, usize)>| {
        for (from, to) in order {
            course[to] = course[to].max(course[from] - most).min(course[from] + most);
        }
    };
    let frames = forward.len();
    let mut backward = forward.clone();
    bound(&mut forward, &mut (1..frames).map(|frame| (frame - 1, frame)));
    bound(&mut backward, &mut (1..frames).rev().map(|frame| (frame, frame - 1)));
    let means = forward.iter().zip(&backward).map(|(a, b)| 0.5 * (a + b));
    values.iter_mut().skip(column).step_by(columns).zip(means).for_each(|(value, m)| *value = m);
}

#[cfg(test)]
mod tests {
    use super::{SLOWEST, lambda, slow_down, smooth};

    #[test]
    fn parabolas_stay_and_fast_shakes_go() {
        let parabola = |i: usize| 0.5 + 0.01 * i as f32 - 1e-4 * (i * i) as f32;
        let shake = |i: usize| if i.is_multiple_of(2) { 0.1 } else { -0.1 };
        let mut values: Vec<f32> =
            (0..100).flat_map(|i| [parabola(i), parabola(i) + shake(i)]).collect();
        smooth(&mut values, 2, lambda(4.0, 1.0 / 30.0));
        for (i, pair) in values.chunks_exact(2).enumerate() {
            assert!((pair[0] - parabola(i)).abs() < 1e-4, "{i}");
            // At the ends there is only one side to know from.
            let bound = if (10..90).contains(&i) { 2e-3 } else { 0.08 };
            assert!((pair[1] - parabola(i)).abs() < bound, "{i}: {}", pair[1] - parabola(i));
        }
    }

    #[test]
    fn a_robot_far_away_stays_where_it_is_however_slow_the_filter() {
        let mut values = vec![5.0_f32; 2000];
        smooth(&mut values, 1, lambda(SLOWEST, 1.0));
        assert!(values.iter().all(|value| (value - 5.0).abs() < 1e-3), "{:?}", &values[..3]);
    }

    #[test]
    fn a_motion_of_the_given_frequency_is_halved() {
        let wave = |i: usize| (core::f32::consts::TAU * 4.0 * i as f32 / 120.0).sin();
        let mut values: Vec<f32> = (0..600).map(wave).collect();
        smooth(&mut values, 1, lambda(4.0, 1.0 / 120.0));
        for (i, value) in values.iter().enumerate().take(480).skip(120) {
            assert!((value - 0.5 * wave(i)).abs() < 5e-3);
        }
    }

    #[test]
    fn a_bounded_speed_is_kept_exactly_and_symmetrically() {
        let mut values: Vec<f32> = (0..40).map(|i| if i < 20 { 0.0 } else { 1.0 }).collect();
        slow_down(&mut values, 1, 0, 0.125);
        assert!(values.windows(2).all(|pair| pair[1] - pair[0] <= 0.125));
        for i in 0..40 {
            assert_eq!(values[i], 1.0 - values[39 - i]);
        }
    }

    #[test]
    fn few_frames_stay_as_they_are() {
        let mut values = vec![1.0, 5.0, 2.0];
        smooth(&mut values, 1, 100.0);
        assert_eq!(values, [1.0, 5.0, 2.0]);
    }
}
