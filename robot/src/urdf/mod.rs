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
//! Link 0 of the mechanism is the root of the file, and stands on the base. The other links follow
//! in the order of the file, except that a parent always comes before its children.
//!
//! # What is read
//! The reader takes, from each `<joint>`, its name and type, `<parent>`, `<child>`, `<origin>`
//! (`xyz`, `rpy`), `<axis>`, `<limit>` (`lower`, `upper`) and `<mimic>`; each of them once. A part
//! that says where links are but cannot be expressed by a mechanism is an [error](UrdfError), and
//! is never ignored. Errors name the line and the element.
//!
//! Limits follow the [specification](https://wiki.ros.org/urdf/XML/joint). A revolute or prismatic
//! joint without a `<limit>` is an error. `lower` and `upper` are zero if they are not written, so
//! a joint with neither cannot move. (Since version 1.2 of the format, in `<robot version="1.2">`,
//! a limit that is not written is infinite.) Two zeros lock a joint too. If a joint mimics another,
//! its limits narrow the range of the followed joint, and a [warning](Robot::warnings) says so. If
//! they would leave that joint one value or none, they are ignored, with a warning. Joints of other
//! types have no limits, whatever `<limit>` says, and a fixed joint stays fixed even if it has a
//! `<mimic>`.
//!
//! # What is not read
//! `<visual>`, `<collision>`, `<inertial>`, `<material>`, `<dynamics>` and their contents are
//! ignored, and so are attributes of `<limit>` about speeds and forces, except `velocity` and
//! `effort`, which become [drives](Robot::drives). These parts say how a robot looks, weighs or is
//! driven, not where its links are.
//!
//! Any other part that does not say where links are is ignored with a [warning](Robot::warnings):
//! parts for simulators and controllers (`<gazebo>`, `<transmission>`, `<sensor>` …), names with
//! a prefix, other attributes and elements, and text. The soft limits of `<safety_controller>` are
//! among them: a controller begins to brake there, but joints may go beyond them up to the
//! `<limit>`.
//!
//! Three faults are treated as other readers treat them, each with a warning. If a joint has two
//! elements where it should have one, such as two `<axis>`, the first is read. Limits in the wrong
//! order are exchanged. Elements that xacro left over, and `<loop_joint>`, are ignored.
//!
//! A name that may be a misspelling of a part that is read is an error, because an ignored limit
//! would be no limit. Such a name differs from a name that is allowed at its place in case, in the
//! order of its letters, or in one letter (lost, added, changed, or exchanged with its neighbour;
//! two in names of more than five letters). Parts that clearly say where something is are errors
//! too: `x`, `y`, `z`, `roll`, `pitch`, `yaw` and quaternions in `<origin>`, `min` and `max` in
//! `<limit>`, joints in links, and numbers as text in `<origin>`, `<axis>`, `<limit>` or `<mimic>`.
//!
//! # Text
//! A file is read in the encoding that it declares ([`Robot::from_bytes`]): UTF-8 or UTF-16, and
//! with the feature `urdf-encodings` any encoding that browsers know, such as Latin-1. The XML
//! declaration may come late or twice, comments may contain `--`, namespace prefixes need no
//! declaration, and a document type is skipped. Four things are errors: entities other than those
//! of XML itself, elements nested more than 500 deep, more than 1,000 attributes of an element, and
//! more than 1,000 different prefixes.

mod element;
mod error;
mod file;
mod names;
mod number;
mod robot;
mod tree;
mod xml;

pub use error::{UrdfError, UrdfWarning};
pub use file::Drive;
pub use robot::{ChangeError, Robot};
