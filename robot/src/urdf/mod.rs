//! Robots from URDF files as [mechanisms](crate::Mechanism).
//!
//! ```
//! use dq8::{Backend, DualQuat};
//! use dq8_robot::urdf::Robot;
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
//! robot.mechanism().job().poses(&angles, &mut poses)?;
//!
//! let bob = robot.link("bob").unwrap();
//! let [x, y, z] = poses[999 * 3 + bob].translation();
//! assert!((x + 1.5 * 0.999_f64.sin()).abs() < 1e-12 && y == 0.0);
//! assert!((z - 2.0 + 1.5 * 0.999_f64.cos()).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Link 0 of the mechanism is the root of the file, at the base; the others follow in the order of
//! the file as far as parents come first.
//!
//! # What is read
//! In `<joint>`: its name and type, `<parent>`, `<child>`, `<origin>` (`xyz`, `rpy`), `<axis>`,
//! `<limit>` (`lower`, `upper`) and `<mimic>`; each of them once. What says where links are and
//! cannot be expressed is an [error](UrdfError), never left out. Errors name the line and the
//! element.
//!
//! Limits are those of the [specification](https://wiki.ros.org/urdf/XML/joint). A revolute or
//! prismatic joint must have a `<limit>`; one without is an error. `lower` and `upper` are zero
//! where they are not written, so a joint with neither cannot move. (Since version 1.2 of the
//! format, in `<robot version="1.2">`, what is not written has no bound.) Two zeros lock a joint
//! too. Limits of a joint that mimics another hold for that one as well, and a
//! [warning](Robot::warnings) says so, but where they would leave it one value or none: those are
//! not read. Joints of other types have no limits, whatever `<limit>` says, and a fixed joint stays
//! fixed, whatever it should mimic.
//!
//! # What is not read
//! `<visual>`, `<collision>`, `<inertial>`, `<material>`, `<dynamics>` and what is in them, and
//! rates of `<limit>` other than `velocity` and `effort`, which are [drives](Robot::drives): they
//! say how a robot looks, weighs or is driven, not where its links are.
//!
//! Everything else that says nothing about places is not read either, and
//! [reported](Robot::warnings): parts for simulators and controllers (`<gazebo>`, `<transmission>`,
//! `<sensor>` …), names with a prefix, other attributes and elements, and text. So are the soft
//! limits of `<safety_controller>`: a controller begins to brake there, but joints may be beyond
//! them, as far as `<limit>` says.
//!
//! Of elements of which a joint has one, the first counts, limits in the wrong order are exchanged,
//! and left-overs of xacro and loops of joints are passed over, as by other readers; each is
//! reported.
//!
//! What may be a misspelt part of what is read stays an error, because a limit that is not read
//! would be none: names that differ from those above, where they may stand, in case, in the order
//! of their letters, or in one letter (lost, added, changed, or exchanged with its neighbour; two
//! in names of more than five letters). So are names that clearly say where something is: `x`, `y`,
//! `z`, `roll`, `pitch`, `yaw` and quaternions in `<origin>`, `min` and `max` in `<limit>`, joints
//! in links, and numbers as text in `<origin>`, `<axis>`, `<limit>` or `<mimic>`.
//!
//! # Text
//! A file is read in the encoding that it declares ([`Robot::from_bytes`]): UTF-8 and UTF-16, and
//! with the feature `urdf-encodings` all that browsers know, such as Latin-1. Its XML declaration
//! may come late or twice, comments may hold any dashes, prefixes need no declaration, and a
//! document type is skipped. Entities other than those of XML itself are an error, and so are
//! elements more than 500 deep in each other, more than 1,000 attributes of an element, and names
//! with more than 1,000 prefixes.

mod element;
mod error;
mod file;
mod robot;
mod tree;
mod xml;

pub use error::{UrdfError, UrdfWarning};
pub use file::Drive;
pub use robot::{ChangeError, Robot};
