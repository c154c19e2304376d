//! Tables of TOML that name links and joints.

use crate::RetargetError;
use crate::role::Role;
use toml::de::{DeTable, DeValue};

/// The value of an entry: a name, and the name of the link at the centre of the joint.
#[derive(Debug)]
pub(crate) struct Entry {
    role: Role,
    name: String,
    centre: Option<String>,
}

impl Entry {
    /// Returns the index of the name.
    pub(crate) fn index(&self, names: &[String]) -> Result<usize, RetargetError> {
        self.find(&self.name, names)
    }

    /// Returns the index of the centre, which is the name itself unless the entry gives another.
    pub(crate) fn centre(&self, names: &[String]) -> Result<usize, RetargetError> {
        self.find(self.centre.as_ref().unwrap_or(&self.name), names)
    }

    fn find(&self, name: &str, names: &[String]) -> Result<usize, RetargetError> {
        names.iter().position(|known| known == name).ok_or_else(|| RetargetError::Table {
            entry: self.role.to_string(),
            reason: format!("there is no {name:?}; there are {}", names.join(", ")),
        })
    }
}

/// Reads the section `links` or `joints` of a table.
pub(crate) fn entries(text: &str, section: &str) -> Result<Vec<(Role, Entry)>, RetargetError> {
    let wrong = |entry: &str, reason: String| RetargetError::Table { entry: entry.into(), reason };
    let table = DeTable::parse(text).map_err(|error| wrong("", error.to_string()))?;
    for (name, _) in table.get_ref() {
        if !["links", "joints"].contains(&&**name.get_ref()) {
            let reason = "the sections are [links] and [joints]".to_owned();
            return Err(wrong(name.get_ref(), reason));
        }
    }
    let is_links = section == "links";
    let Some(section) = table.get_ref().get(section) else { return Ok(Vec::new()) };
    let DeValue::Table(section) = section.get_ref() else {
        return Err(wrong("", "a section is a table of roles".to_owned()));
    };
    let mut entries = Vec::new();
    for (name, value) in section {
        let name: &str = name.get_ref();
        let role = Role::named(name).ok_or_else(|| {
            let all: Vec<_> = Role::ALL.iter().map(|role| role.name()).collect();
            wrong(name, format!("there is no such role; there are {}", all.join(", ")))
        })?;
        let text = |value: &DeValue<'_>| match value {
            DeValue::String(text) => Some(text.to_string()),
            _ => None,
        };
        let entry = match value.get_ref() {
            DeValue::Table(parts) => {
                let part = |key: &str| text(parts.get(key)?.get_ref());
                let (link, centre) = (part("link"), part("centre"));
                let read = usize::from(link.is_some()) + usize::from(centre.is_some());
                link.filter(|_| parts.len() == read && is_links).map(|name| Entry {
                    role,
                    name,
                    centre,
                })
            }
            value => text(value).map(|name| Entry { role, name, centre: None }),
        };
        let entry = entry.ok_or_else(|| {
            let reason = if is_links {
                "the value is a name, or { link = \"NAME\", centre = \"NAME\" }"
            } else {
                "the value is the name of a joint"
            };
            wrong(name, reason.to_owned())
        })?;
        entries.push((role, entry));
    }
    Ok(entries)
}
