//! [`Settings`], the wishes about a motion.

use crate::RetargetError;
use crate::smooth::SLOWEST;

/// The wishes about a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The frames per second of the motion, 30 by default. Frames between those of the clip are
    /// interpolated. It is from 0.001 to 100,000.
    pub fps: f64,
    /// The frame in which the person stands as the robot does at rest. By default, `None`, it is
    /// found.
    pub rest: Option<usize>,
    /// The height of the robot's ankles above its soles in metres. By default, `None`, it is that
    /// of the collision shapes of the feet.
    pub ankle: Option<f64>,
    /// `true`, the default, if feet are held flat on the ground while the person's feet stand.
    pub feet: bool,
    /// The frequency in Hz that passes over the whole motion halve, 4 by default; at least 0.003 of
    /// `fps`. With `None`, nothing is smoothed.
    pub smooth: Option<f64>,
    /// The greatest speeds of joints, [`Speeds::Free`] by default.
    pub speeds: Speeds,
    /// `true`, the default, if the collision shapes of the robot are pushed apart where they meet.
    pub collide: bool,
}

/// The greatest speeds that joints may have.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Speeds {
    /// Joints may have any speed.
    #[default]
    Free,
    /// Each joint has the speed that the robot's file gives to it, if that is more than zero.
    File,
    /// All joints have this speed, in rad/s or metres per second.
    AtMost(f64),
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            fps: 30.0,
            rest: None,
            ankle: None,
            feet: true,
            smooth: Some(4.0),
            speeds: Speeds::Free,
            collide: true,
        }
    }
}

impl Settings {
    /// Settings with which each frame follows the person as it is: feet are not held, and nothing
    /// is smoothed or pushed.
    #[must_use]
    pub fn plain() -> Self {
        Self { feet: false, smooth: None, collide: false, ..Self::default() }
    }

    /// Checks the settings.
    ///
    /// # Errors
    /// If a setting is out of its range.
    pub fn check(&self) -> Result<(), RetargetError> {
        let speed = match self.speeds {
            Speeds::AtMost(speed) => Some(speed),
            Speeds::Free | Speeds::File => None,
        };
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let is_smooth = |frequency: f64| positive(frequency) && frequency >= SLOWEST * self.fps;
        for (name, value, fits) in [
            ("fps", Some(self.fps), (1e-3..=1e5).contains(&self.fps)),
            ("ankle", self.ankle, self.ankle.is_none_or(f64::is_finite)),
            ("smooth", self.smooth, self.smooth.is_none_or(is_smooth)),
            ("speeds", speed, speed.is_none_or(positive)),
        ] {
            if let (Some(value), false) = (value, fits) {
                return Err(RetargetError::Setting { name, value });
            }
        }
        Ok(())
    }
}
