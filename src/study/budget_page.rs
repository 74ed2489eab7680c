//! The page that `--budget` prints.

use super::{
    budget::{Budget, Depths, FARTHEST_PX, Growth},
    chains::Chain,
    table::{number, short},
};
use std::fmt::Write;

impl Budget {
    /// A line for each chain, and one for each thing that is said of them.
    pub fn page(&self) -> String {
        let [pixels, hits] = self.pixels;
        let mut page = format!(
            "{hits} of {pixels} random pixels show something; the budget is {} px.\n\n",
            short(self.px)
        );
        let simplest = self.simplest().map(|tried| tried.chain);
        let header = ["", "differ", "off by (px)", "ns a pick"];
        line(&mut page, header, "");
        for tried in &self.tried {
            let off = match tried.worst_px {
                px if px.is_finite() => number(px),
                _ => format!("> {FARTHEST_PX}"),
            };
            let (differ, ns) = (tried.differ.to_string(), format!("{:.0}", tried.ns));
            let is_simplest = simplest == Some(tried.chain);
            let verdict = if is_simplest {
                "   the simplest that suffices"
            } else {
                ""
            };
            line(&mut page, [tried.chain.name(), &differ, &off, &ns], verdict);
        }
        let lines = [
            self.saving(),
            self.breaking(),
            self.depth.told(),
            format!(
                "What differs at none of {pixels} pixels differs, with 95 % confidence, at fewer than 3 in {pixels}."
            ),
        ];
        page + "\n" + &lines.join("\n") + "\n"
    }

    fn saving(&self) -> String {
        let Some(simplest) = self.simplest() else {
            return String::new();
        };
        let alone = format!(
            "Sightline tests several triangles at once; one at a time, as the others do, it takes {:.0} ns.",
            self.one_by_one_ns
        );
        if simplest.chain == Chain::Sightline {
            return format!("No chain of rounded numbers stays within the budget. {alone}");
        }
        let share = 100.0 * (self.one_by_one_ns / simplest.ns - 1.0);
        let than = if share < 0.0 { "less" } else { "more" };
        format!(
            "{alone} That is {:.0} % {than} than the simplest.",
            share.abs()
        )
    }

    fn breaking(&self) -> String {
        let told = self.breaks.iter().map(|reach| {
            let told = |grown: f64| match reach.of {
                Growth::Offset => format!("{} units from the world's origin", number(grown)),
                Growth::Lens => {
                    let times = short(grown);
                    format!("{times} times as far away, through a lens as much longer")
                }
            };
            let who = match reach.of {
                Growth::Offset => "the scene",
                Growth::Lens => "the eye",
            };
            match (reach.held, reach.broke) {
                (Some(held), Some(broke)) => {
                    format!("with {who} {}, and breaks at {}", told(held), number(broke))
                }
                (None, Some(broke)) => format!("breaks with {who} {}", told(broke)),
                (held, None) => format!(
                    "with {who} {}, as far as was tried",
                    told(held.unwrap_or_default())
                ),
            }
        });
        let told: Vec<String> = told.collect();
        if told.is_empty() {
            "Exact decisions hold wherever scene and eye are.".to_owned()
        } else {
            format!("The simplest holds {}.", told.join("; "))
        }
    }
}

impl Depths {
    fn told(&self) -> String {
        let two = format!("of the {} pixels with two surfaces", self.pixels);
        if self.pixels == 0 {
            return "Depth buffer: no pixel has a second surface behind the first.".to_owned();
        }
        let enough = self.alike.iter().position(|(_, alike)| *alike == 0);
        let (failing, verdict) = match enough {
            Some(at) => (&self.alike[..at], format!("{} suffice", self.alike[at].0)),
            None => (&self.alike[..], "none suffices".to_owned()),
        };
        let failing = failing.iter();
        let failing = failing
            .map(|(name, alike)| format!("{name} store one number for both at {alike} {two}; "));
        format!("Depth buffer: {}{verdict}.", failing.collect::<String>())
    }
}

/// Adds a line of the table.
fn line(page: &mut String, [name, differ, off, ns]: [&str; 4], verdict: &str) {
    let _ = writeln!(
        page,
        "  {name:<30} {differ:>6}  {off:>11}  {ns:>9}{verdict}"
    );
}
