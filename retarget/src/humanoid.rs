//! [`Humanoid`], a robot with the roles that its links have.

use crate::collision::{KnownShapes, Shape as Collision, Shapes, Sole};
use crate::names::{find, plain};
use crate::role::Role;
use crate::shape::{Body, Shape, facing, leftward};
use crate::{RetargetError, table};
use dq8::{DualQuat, Quat};
use dq8_robot::JointKind;
use dq8_robot::urdf::{ChangeError, Robot};
use std::fmt;

/// A link that has a role.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// The index of the link.
    pub link: usize,
    /// The index of the link whose origin is the place of the part.
    pub centre: usize,
    /// The source of the knowledge about the part.
    pub source: Source,
}

/// The source of the knowledge that a link has a role.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The name of the link.
    Name,
    /// The shape of the robot.
    Shape,
    /// The table.
    Table,
}

/// A humanoid robot: its mechanism with a floating base, and the roles of its links. It is
/// displayed as the list of the roles.
///
/// Roles are found by the names of links. The shape of the robot checks them and gives the roles
/// that names do not: two mirrored chains of hinges that reach lowest are legs, two more are arms,
/// and knees bend backward. A table says the last word.
///
/// ```
/// # let urdf = include_str!("../../robot/robots/humanoid.urdf");
/// use dq8_retarget::{Humanoid, Role};
/// let humanoid = Humanoid::from_urdf(urdf)?;
/// let foot = humanoid.part(Role::LeftFoot).unwrap();
/// assert_eq!(humanoid.robot().link_names()[foot.link], "left_foot");
/// # Ok::<(), dq8_retarget::RetargetError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Humanoid {
    robot: Robot,
    parts: [Option<Part>; Role::COUNT],
    /// The rotation of the base that turns the robot to x forward and y to the left.
    axes: Quat<f64>,
    collisions: Shapes,
    told: Vec<String>,
}

impl Humanoid {
    /// Reads a humanoid from the text of a URDF file.
    ///
    /// # Errors
    /// If the file is not understood, or the robot does not have two legs.
    pub fn from_urdf(text: &str) -> Result<Self, RetargetError> {
        Self::from_bytes(text.as_bytes(), None)
    }

    /// Reads a humanoid from the bytes of a URDF file. The section `[links]` of a table of TOML
    /// gives roles to links, such as `left_foot = "ankle_2"`, or, where the origin of another link
    /// is the place of the part, `left_hip = { link = "thigh", centre = "hip_roll" }`.
    ///
    /// # Errors
    /// If the file or the table is not understood, or the robot does not have two legs.
    pub fn from_bytes(urdf: &[u8], table: Option<&str>) -> Result<Self, RetargetError> {
        let robot = with_floating_base(Robot::from_bytes(urdf)?)?;
        // Shapes of collisions are read from UTF-8 text alone.
        let collisions = Shapes::read(std::str::from_utf8(urdf).unwrap_or_default(), &robot);
        let mut humanoid = Self {
            robot,
            parts: [None; Role::COUNT],
            axes: Quat::IDENTITY,
            collisions,
            told: Vec::new(),
        };
        let poses = humanoid.poses(&humanoid.zero())?;
        humanoid.find(&poses, table)?;
        let left = leftward(|role| Some(poses[humanoid.part(role)?.centre].translation()));
        humanoid.axes = facing(left);
        let KnownShapes { links, unread } = humanoid.known_shapes();
        if unread > 0 {
            humanoid.told.push(format!(
                "{unread} of {links} links have meshes as collision shapes, which are not read: they \
                 are not pushed apart, and self-hits are not known"
            ));
        }
        Ok(humanoid)
    }

    fn find(&mut self, poses: &[DualQuat<f64>], table: Option<&str>) -> Result<(), RetargetError> {
        let shape = Shape::new(&self.robot, poses);
        let mut body = shape.body();
        if shape.is_too_large() {
            self.told.push("the robot has so many links that its shape tells no roles".to_owned());
        }
        let links: Vec<_> = self.robot.link_names().iter().map(|name| plain(name)).collect();
        let by_name = |role: Role| -> Option<Part> {
            let find = |names: &[&str]| find(&links, role.side(), names);
            let link = find(role.names().links)?;
            let centre = find(role.names().centres).unwrap_or(link);
            let link = if role.is_foot() { last_of_the_ankle(&self.robot, link) } else { link };
            let centre = if role.names().centres.is_empty() { link } else { centre };
            Some(Part { link, centre, source: Source::Name })
        };
        let mut named = Role::ALL.map(by_name);
        if are_arms(&shape, &body, &named) {
            body = Body::default();
        }
        self.told.extend(exchanged(&shape, &mut body, &named));
        if body.legs.is_some() && body.is_front_assumed {
            self.told.push("the knees do not tell where front is".to_owned());
        }
        let mut parts = [None; Role::COUNT];
        for role in Role::ALL {
            let own =
                body.part(role).map(|[link, centre]| Part { link, centre, source: Source::Shape });
            let index = role as usize;
            let name = named[index].take_if(|part| !fits(&shape, &body, role, part));
            if let (Some(refused), Some(own)) = (name, own) {
                let names = self.robot.link_names();
                self.told.push(format!(
                    "{} is not {role}, whatever its name says: {} is",
                    names[refused.link], names[own.link]
                ));
            }
            parts[index] = named[index].or(own);
        }
        if let Some(table) = table {
            for (role, entry) in table::entries(table, "links")? {
                let names = self.robot.link_names();
                let (link, centre) = (entry.index(names)?, entry.centre(names)?);
                parts[role as usize] = Some(Part { link, centre, source: Source::Table });
            }
        }
        self.parts = parts;
        self.check(&shape, poses)
    }

    /// Checks that the robot stands on two legs: hips above knees above feet, one above the other
    /// in the tree of its joints, and left and right apart.
    fn check(&self, shape: &Shape<'_>, poses: &[DualQuat<f64>]) -> Result<(), RetargetError> {
        let legs = [Role::LeftHip, Role::LeftKnee, Role::LeftFoot].into_iter().chain([
            Role::RightHip,
            Role::RightKnee,
            Role::RightFoot,
        ]);
        let mut missing: Vec<_> = legs.filter(|&role| self.part(role).is_none()).collect();
        let height = |role: Role| Some(poses[self.part(role)?.centre].translation()[2]);
        for role in Role::ALL.into_iter().filter(|role| role.is_below_hips()) {
            let Some(on) = role.carrier() else { continue };
            let (Some(part), Some(above)) = (self.part(role), self.part(on)) else { continue };
            let falls = height(on) > height(role);
            let moves = shape.carries(above.link, part.link);
            if (!falls || !moves) && !missing.contains(&role) {
                missing.push(role);
            }
        }
        if self.part(Role::Pelvis).is_none() {
            missing.push(Role::Pelvis);
        }
        if missing.is_empty() {
            return Ok(());
        }
        let (robot, links) = (self.robot.name().to_owned(), self.robot.link_names().to_vec());
        Err(RetargetError::NoLegs { robot, missing, links })
    }

    /// Returns the values with all joints at zero, or as near as their limits let them be.
    pub(crate) fn zero(&self) -> Vec<f64> {
        let limits = self.robot.value_limits();
        let zero = |limits: Option<[f64; 2]>| limits.map_or(0.0, |[a, b]| 0.0_f64.clamp(a, b));
        let mut values: Vec<f64> = limits.into_iter().map(zero).collect();
        values[..4].copy_from_slice(&self.axes.to_array());
        values
    }

    pub(crate) fn poses(&self, values: &[f64]) -> Result<Vec<DualQuat<f64>>, RetargetError> {
        let mut poses = vec![DualQuat::IDENTITY; self.robot.mechanism().links()];
        self.robot.mechanism().link_poses(values, &mut poses)?;
        Ok(poses)
    }

    /// The robot. The first joint that moves is the floating one of the base.
    #[must_use]
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// Returns the part that has this role.
    #[must_use]
    pub fn part(&self, role: Role) -> Option<Part> {
        self.parts[role as usize]
    }

    /// Sentences about parts whose names mislead, about what had to be assumed, and about shapes
    /// that are not read.
    #[must_use]
    pub fn told(&self) -> &[String] {
        &self.told
    }

    /// Returns the roles as a table that [`from_bytes`](Self::from_bytes) reads.
    #[must_use]
    pub fn table(&self) -> String {
        let mut text = "[links]\n".to_owned();
        let names = self.robot.link_names();
        for role in Role::ALL {
            let Some(Part { link, centre, .. }) = self.part(role) else { continue };
            let line = if link == centre {
                format!("{role} = {}\n", quoted(&names[link]))
            } else {
                let (link, centre) = (quoted(&names[link]), quoted(&names[centre]));
                format!("{role} = {{ link = {link}, centre = {centre} }}\n")
            };
            text += &line;
        }
        text
    }

    pub(crate) fn collisions(&self) -> &[Collision] {
        &self.collisions.all
    }

    /// Returns how many links have collision shapes that are known. Meshes are not read.
    #[must_use]
    pub fn known_shapes(&self) -> KnownShapes {
        self.collisions.known(&self.robot)
    }

    /// Returns the sole of a foot. Returns `None` if the file has no shape at the foot.
    pub(crate) fn sole(&self, poses: &[DualQuat<f64>], role: Role) -> Option<Sole> {
        Sole::of(&self.robot, &self.collisions.all, poses, self.part(role)?.link)
    }
}

/// Returns `true` if the names say that the legs of the shape are arms: the arms of a robot that
/// has no legs reach lowest, too.
fn are_arms(shape: &Shape<'_>, body: &Body, named: &[Option<Part>; Role::COUNT]) -> bool {
    let arms = [Role::LeftShoulder, Role::LeftElbow, Role::LeftHand].into_iter().chain([
        Role::RightShoulder,
        Role::RightElbow,
        Role::RightHand,
    ]);
    let mut links = arms.filter_map(|role| Some(named[role as usize]?.link));
    body.legs.as_ref().is_some_and(|legs| {
        links.any(|link| legs.limbs.iter().any(|limb| shape.place_on(limb, link).is_some()))
    })
}

/// Exchanges left and right of the shape where the names of most parts say the opposite, and
/// returns a sentence about that if the knees had been sure.
fn exchanged(
    shape: &Shape<'_>,
    body: &mut Body,
    named: &[Option<Part>; Role::COUNT],
) -> Option<String> {
    let mut votes = 0_i32;
    for (side, roles) in Role::PAIRS.iter().flat_map(|pair| pair.iter().enumerate()) {
        let (Some(part), Some(pair)) = (named[*roles as usize], body.pair(*roles)) else {
            continue;
        };
        for (own, limb) in pair.limbs.iter().enumerate() {
            if shape.place_on(limb, part.link).is_some() {
                votes += if own == side { 1 } else { -1 };
            }
        }
    }
    if votes >= 0 {
        return None;
    }
    for pair in [body.legs.as_mut(), body.arms.as_mut()].into_iter().flatten() {
        pair.limbs.reverse();
    }
    let knew = !body.is_front_assumed;
    body.is_front_assumed = false;
    knew.then(|| "knees bend forward, if the names tell left from right".to_owned())
}

/// Returns `true` if the shape agrees that a part with this name may have the role, or does not
/// know better.
fn fits(shape: &Shape<'_>, body: &Body, role: Role, part: &Part) -> bool {
    let Some(own) = body.part(role) else {
        // A limb that the shape knows has no such part, or the shape knows nothing of the limb.
        return match role {
            Role::Chest => body.legs.as_ref().is_none_or(|legs| {
                !shape.is_rigid(legs.trunk, part.link) && !shape.is_on_a_limb(body, part.link)
            }),
            Role::Head => !shape.is_on_a_limb(body, part.link),
            _ => body.pair(role).is_none_or(|pair| {
                let limb = &pair.limbs[usize::from(role.side() == Some("right"))];
                shape.place_on(limb, part.link) == Some(limb.links.len() - 1)
            }),
        };
    };
    match (role, body.pair(role)) {
        (Role::Head, _) => !shape.is_on_a_limb(body, part.link),
        (_, None) => shape.is_rigid(own[0], part.link),
        (_, Some(pair)) => {
            let limb = &pair.limbs[usize::from(role.side() == Some("right"))];
            let place = |link: usize| shape.place_on(limb, link);
            let (Some(link), Some(centre)) = (place(part.link), place(part.centre)) else {
                return false;
            };
            let middle = limb.middle;
            match role {
                Role::LeftShoulder | Role::RightShoulder | Role::LeftHip | Role::RightHip => {
                    link < middle && centre <= link
                }
                Role::LeftElbow | Role::RightElbow | Role::LeftKnee | Role::RightKnee => {
                    link == middle
                }
                Role::LeftFoot | Role::RightFoot => link == limb.links.len() - 1,
                _ => link > middle,
            }
        }
    }
}

/// Returns the link that has the sole: the last one of a chain of hinges. Some ankles roll first
/// and pitch then, and their names tell nothing about the order. Toes are not of the chain.
fn last_of_the_ankle(robot: &Robot, mut link: usize) -> usize {
    loop {
        let mut hinges = robot
            .joints()
            .iter()
            .enumerate()
            .filter(|(_, joint)| joint.parent == Some(link) && joint.kind.values() > 0);
        match (hinges.next(), hinges.next()) {
            (Some((next, _)), None) if !plain(&robot.link_names()[next]).contains("toe") => {
                link = next;
            }
            _ => return link,
        }
    }
}

/// Returns a string as TOML writes it.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            _ if letter.is_control() => quoted += &format!("\\u{:04X}", u32::from(letter)),
            _ => quoted.push(letter),
        }
    }
    quoted + "\""
}

/// Returns the robot with a base that moves freely: as it is, if a floating joint of the file
/// carries all other links that move, and otherwise with one that carries the root.
fn with_floating_base(robot: Robot) -> Result<Robot, ChangeError> {
    let joints = robot.joints();
    let moves = |&link: &usize| joints[link].kind != JointKind::Fixed;
    let Some(base) = (0..joints.len()).find(moves) else { return robot.floating() };
    // Parents stand before what they carry.
    let mut carried = vec![false; joints.len()];
    for (link, joint) in joints.iter().enumerate() {
        carried[link] = link == base || joint.parent.is_some_and(|parent| carried[parent]);
    }
    let carries_all = (0..joints.len()).filter(moves).all(|link| carried[link]);
    let floats = joints[base].kind == JointKind::Floating;
    if floats && carries_all { Ok(robot) } else { robot.floating() }
}

impl fmt::Display for Humanoid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.robot.name())?;
        for role in Role::ALL {
            write!(f, "  {:<15}", role.name())?;
            let Some(Part { link, centre, source }) = self.part(role) else {
                writeln!(f, " not found")?;
                continue;
            };
            write!(f, " {}", self.robot.link_names()[link])?;
            if link != centre {
                write!(f, " at {}", self.robot.link_names()[centre])?;
            }
            f.write_str(match source {
                Source::Name => "\n",
                Source::Shape => ", by the shape\n",
                Source::Table => ", by the table\n",
            })?;
        }
        self.told.iter().try_for_each(|sentence| writeln!(f, "  {sentence}"))
    }
}
