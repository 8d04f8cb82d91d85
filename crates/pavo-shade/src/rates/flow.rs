//! The least cut of a network (Dinic 1970: shortest augmenting paths by layers).

use std::collections::VecDeque;

/// A capacity that no cut goes through.
pub const UNLIMITED: u64 = u64::MAX / 4;

struct Edge {
    to: usize,
    left: u64,
}

/// Nodes with edges of limited capacity; an edge and its reverse stand side by side.
pub struct Network {
    edges: Vec<Edge>,
    from: Vec<Vec<usize>>,
}

impl Network {
    pub fn new(nodes: usize) -> Self {
        Self { edges: Vec::new(), from: vec![Vec::new(); nodes] }
    }

    pub fn edge(&mut self, from: usize, to: usize, capacity: u64) {
        for (from, to, left) in [(from, to, capacity), (to, from, 0)] {
            self.from[from].push(self.edges.len());
            self.edges.push(Edge { to, left });
        }
    }

    /// For each node, whether it is on the source's side of the least cut that is nearest to the source.
    pub fn source_side(mut self, source: usize, sink: usize) -> Vec<bool> {
        loop {
            let layers = self.layers(source);
            if layers[sink].is_none() {
                return layers.iter().map(Option::is_some).collect();
            }
            let mut next = vec![0; self.from.len()];
            while self.augment(source, sink, &layers, &mut next) {}
        }
    }

    /// How many edges with room lead from the source to each node.
    fn layers(&self, source: usize) -> Vec<Option<usize>> {
        let mut layers = vec![None; self.from.len()];
        layers[source] = Some(0);
        let mut pending = VecDeque::from([source]);
        while let Some(node) = pending.pop_front() {
            for &edge in &self.from[node] {
                let Edge { to, left } = self.edges[edge];
                if left > 0 && layers[to].is_none() {
                    layers[to] = layers[node].map(|layer: usize| layer + 1);
                    pending.push_back(to);
                }
            }
        }
        layers
    }

    /// Fills one path through the layers; false where there is none left. `next` are the edges not yet found blocked.
    fn augment(&mut self, source: usize, sink: usize, layers: &[Option<usize>], next: &mut [usize]) -> bool {
        let mut path: Vec<usize> = Vec::new();
        let mut node = source;
        while node != sink {
            let Some(&edge) = self.from[node].get(next[node]) else {
                // A dead end: go back over the edge that led here.
                let Some(edge) = path.pop() else { return false };
                node = self.edges[edge ^ 1].to;
                next[node] += 1;
                continue;
            };
            let Edge { to, left } = self.edges[edge];
            if left > 0 && layers[to] == layers[node].map(|layer| layer + 1) {
                path.push(edge);
                node = to;
            } else {
                next[node] += 1;
            }
        }
        let room = path.iter().map(|&edge| self.edges[edge].left).min().unwrap_or(0);
        for &edge in &path {
            self.edges[edge].left -= room;
            self.edges[edge ^ 1].left += room;
        }
        room > 0
    }
}

#[cfg(test)]
mod tests {
    use super::{Network, UNLIMITED};

    #[test]
    fn the_least_cut_goes_through_the_narrowest_edges() {
        // 0 -> {1, 2} -> 3 -> 4, where the way over 3 is wider than the ways to 1 and 2 together.
        let cases = [([1, 2, 9], [true, false, false, false, false]), ([9, 9, 4], [true, true, true, true, false])];
        for ([first, second, last], expected) in cases {
            let mut network = Network::new(5);
            network.edge(0, 1, first);
            network.edge(0, 2, second);
            network.edge(1, 3, UNLIMITED);
            network.edge(2, 3, UNLIMITED);
            network.edge(3, 4, last);
            assert_eq!(network.source_side(0, 4), expected);
        }
    }
}
