//! A robot on something else, or with something more: the names and limits follow.

use super::drive::Drive;
use super::robot::{Robot, value_names};
use crate::{Joint, MechanismError, OwnedMechanism};
use dq8::DualQuat;
use dq8::seams::errors;

errors! {
    /// What a robot cannot be changed to.
    #[derive(Clone, Debug, PartialEq)]
    ChangeError {
        /// A name that something of the robot has already.
        Taken { name: String = "The name." } => "the robot has a {name:?} already";
        /// A link that there is not.
        Unknown { name: String = "The name.", links: Vec<String> = "The names that there are." }
            => "the robot has no link {name:?}; it has {}", links.join(", ");
        /// What a mechanism refuses.
        Mechanism(error: MechanismError) => "{error}";
    }
}

impl Robot {
    /// The same robot with a base that moves freely, by a joint of the name `root_joint`: the seven
    /// values of a [floating joint](crate::JointKind::Floating) and its six rates come before all
    /// others.
    ///
    /// ```
    /// # use dq8_robot::urdf::Robot;
    /// let drone = Robot::from_urdf("<robot name='drone'><link name='body'/></robot>")?.floating()?;
    /// assert_eq!(drone.value("root_joint.qw"), Some(3));
    /// assert_eq!((drone.mechanism().values(), drone.mechanism().rates()), (7, 6));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If a joint has the name.
    pub fn floating(self) -> Result<Self, ChangeError> {
        self.on("root_joint", Joint::floating(None, DualQuat::IDENTITY))
    }

    /// The same robot on a joint of this name: a rail, a turntable, a floor where it drives. The
    /// joint carries the root, and stands on the base.
    ///
    /// # Errors
    /// If a joint has the name, or a mechanism refuses the joint, which is number 0.
    pub fn on(mut self, name: &str, joint: Joint<f64>) -> Result<Self, ChangeError> {
        if self.joint(name).is_some() {
            return Err(ChangeError::Taken { name: name.into() });
        }
        self.joints[0] = joint;
        self.drives[0] = Drive::FREE;
        self.joint_names[0] = Some(name.into());
        self.rebuilt()
    }

    /// The same robot with a link of its own name, fixed on another at a pose: a tool, a camera, a
    /// sole. It is the last.
    ///
    /// ```
    /// # use dq8_robot::urdf::Robot;
    /// use dq8::DualQuat;
    /// let body = Robot::from_urdf("<robot name='drone'><link name='body'/></robot>")?;
    /// let drone = body.with_tool("camera", "body", DualQuat::from_translation([0.1, 0.0, 0.0]))?;
    /// assert_eq!(drone.link("camera"), Some(1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If there is no such link, a link or joint has the name, or the pose is farther than 10⁻³
    /// from unit.
    pub fn with_tool(
        mut self,
        name: &str,
        link: &str,
        pose: DualQuat<f64>,
    ) -> Result<Self, ChangeError> {
        let Some(parent) = self.link(link) else {
            return Err(ChangeError::Unknown { name: link.into(), links: self.link_names });
        };
        if self.link(name).is_some() || self.joint(name).is_some() {
            return Err(ChangeError::Taken { name: name.into() });
        }
        self.links.insert(name.into(), self.joints.len());
        self.joints.push(Joint::fixed(Some(parent), pose));
        self.drives.push(Drive::FREE);
        self.link_names.push(name.into());
        self.joint_names.push(Some(name.into()));
        self.rebuilt()
    }

    fn rebuilt(self) -> Result<Self, ChangeError> {
        let mechanism = OwnedMechanism::new(&self.joints)?;
        let value_names = value_names(&self.joints, &self.joint_names);
        Ok(Self { mechanism, value_names, ..self })
    }
}
