//! Robots from URDF files as [mechanisms](dq8::mechanism) of dq8.
//!
//! ```
//! use dq8::{Backend, DualQuat};
//! use dq8_urdf::Robot;
//! let robot = Robot::from_urdf(
//!     r#"<robot name="pendulum">
//!          <link name="base"/>
//!          <link name="rod"/>
//!          <link name="bob"/>
//!          <joint name="swing" type="continuous">
//!            <parent link="base"/>
//!            <child link="rod"/>
//!            <origin xyz="0 0 2" rpy="0 0 0"/>
//!            <axis xyz="0 1 0"/>
//!          </joint>
//!          <joint name="end" type="fixed">
//!            <parent link="rod"/>
//!            <child link="bob"/>
//!            <origin xyz="0 0 -1.5" rpy="0 0 0"/>
//!          </joint>
//!        </robot>"#,
//! )?;
//! assert_eq!(robot.value_names(), ["swing"]);
//! assert_eq!(robot.link_names(), ["base", "rod", "bob"]);
//!
//! // The poses of all links at 1,000 angles, on the lanes of the CPU.
//! let angles: Vec<f64> = (0..1000).map(|i| 0.001 * f64::from(i)).collect();
//! let mut poses = vec![DualQuat::IDENTITY; 1000 * robot.link_names().len()];
//! Backend::best().link_poses(robot.mechanism(), &angles, &mut poses)?;
//!
//! let bob = robot.link("bob").unwrap();
//! let [x, y, z] = poses[999 * 3 + bob].translation();
//! assert!((x + 1.5 * 0.999_f64.sin()).abs() < 1e-12 && y == 0.0);
//! assert!((z - 2.0 + 1.5 * 0.999_f64.cos()).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Link 0 of the mechanism is the root of the file, at the base; the others follow in the order of the file
//! as far as parents come first.
//!
//! # What is read
//! In `<joint>`: its name and type, `<parent>`, `<child>`, `<origin>` (`xyz`, `rpy`), `<axis>`, `<limit>` (`lower`,
//! `upper`) and `<mimic>`. What says where links are and cannot be expressed is an [error](UrdfError), never left out, and so
//! are elements, attributes and text in a joint that the format does not have there: a misspelt limit would be none. Errors
//! name the line and the element.
//!
//! Limits are those of the [specification](https://wiki.ros.org/urdf/XML/joint). A revolute or prismatic joint must have a
//! `<limit>`; one without is an error. `lower` and `upper` are zero where they are not written, so a joint with neither
//! cannot move. (Since version 1.2 of the format, in `<robot version="1.2">`, what is not written has no bound.) Two zeros
//! lock a joint too. Joints of other types have no limits, whatever `<limit>` says.
//!
//! # What is ignored
//! `<visual>`, `<collision>`, `<contact>`, `<inertial>`, `<material>`, `<dynamics>`, `<calibration>`, `<transmission>`,
//! `<sensor>`, `<gazebo>`, `<ros2_control>`, `<mujoco>` and what is in them: they say how a robot looks, weighs, is driven or
//! simulated, not where its links are. `effort`, `velocity` and other rates of `<limit>` for the same reason. So are the soft
//! limits of `<safety_controller>`: a controller begins to brake there, but joints may be beyond them, as far as
//! `<limit>` says. Attributes of `<robot>` and `<link>` other than names and versions, and attributes with a prefix, say nothing
//! about places either.
#![forbid(unsafe_code)]

mod element;
mod encoding;
mod error;
mod file;
mod joint;
mod mimics;
mod place;
mod robot;
mod spelling;
mod tree;
mod warning;
mod xml;

pub use error::UrdfError;
pub use robot::Robot;
pub use warning::UrdfWarning;
