//! Which atoms lie beside each other, and which are connected.

/// Atoms across one edge of the regular mesh.
#[derive(Clone, Debug)]
pub(super) struct Neighbours {
    starts: Vec<usize>,
    others: Vec<u32>,
}

impl Neighbours {
    /// Of `atoms` atoms under these faces; ascending.
    pub fn new(atoms: usize, triangles: &[[u32; 3]]) -> Self {
        let mut pairs: Vec<[u32; 2]> = (triangles.iter())
            .flat_map(|&[a, b, c]| [[a, b], [b, a], [b, c], [c, b], [c, a], [a, c]])
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        let mut starts = vec![0; atoms + 1];
        pairs
            .iter()
            .for_each(|&[from, _]| starts[from as usize + 1] += 1);
        for atom in 0..atoms {
            starts[atom + 1] += starts[atom];
        }
        Self {
            starts,
            others: pairs.into_iter().map(|[_, to]| to).collect(),
        }
    }

    /// Those beside one.
    pub fn of(&self, atom: usize) -> &[u32] {
        &self.others[self.starts[atom]..self.starts[atom + 1]]
    }

    /// Connected parts of the atoms that are `inside`, in the order of their lowest atom, ascending each.
    pub fn parts(&self, inside: &[bool]) -> Vec<Vec<u32>> {
        let mut seen = vec![false; inside.len()];
        let mut parts = Vec::new();
        for start in 0..inside.len() {
            if !inside[start] || seen[start] {
                continue;
            }
            seen[start] = true;
            let mut part = vec![start as u32];
            let mut next = 0;
            while let Some(&atom) = part.get(next) {
                next += 1;
                for &other in self.of(atom as usize) {
                    if inside[other as usize] && !seen[other as usize] {
                        seen[other as usize] = true;
                        part.push(other);
                    }
                }
            }
            // Ascending, so that membership can be looked up by bisection.
            part.sort_unstable();
            parts.push(part);
        }
        parts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn atoms_that_only_meet_outside_are_two_parts() {
        // A strip of four triangles over six atoms.
        let strip = [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4]];
        let neighbours = Neighbours::new(6, &strip);
        assert_eq!(neighbours.of(2), [0, 1, 3, 4]);
        let parts = neighbours.parts(&[true, true, false, false, true, true]);
        assert_eq!(parts, [vec![0, 1], vec![4, 5]]);
        assert!(neighbours.parts(&[false; 6]).is_empty());
    }
}
