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
//! as far as parents come first. Masses, shapes and speeds have no place in a mechanism. What says where
//! links are and cannot be expressed is an [error](UrdfError), never left out. Elements and attributes that the
//! format does not know, a misspelt one too, are not seen.
#![forbid(unsafe_code)]

mod error;
mod joint;
mod robot;
mod tree;

pub use error::UrdfError;
pub use robot::Robot;
