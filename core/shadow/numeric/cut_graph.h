#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace swaplight {

/// Vertices that are drawn to a source or a sink and linked to each other, and the cut between the two that
/// costs least. The algorithm of Boykov and Kolmogorov, "An experimental comparison of min-cut/max-flow
/// algorithms for energy minimization in vision", PAMI 2004, section 3: one search tree grows from each
/// terminal; where they meet, flow is pushed along the path, and what that cuts off is adopted again.
class CutGraph {
 public:
  /// `links`: how many will be added, for the memory.
  CutGraph(int vertices, int links);

  /// What it costs to take a vertex from the source's side (> 0), or from the sink's (< 0). Once a vertex.
  void setPull(int vertex, float pull) { at(vertex).pull = pull; }
  /// What it costs to part two vertices, >= 0.
  void link(int a, int b, float cost);

  void solve();
  /// After solve(). A vertex that either side may have stays where a tree last held it.
  [[nodiscard]] bool onSourceSide(int vertex) const { return !m_vertices[static_cast<size_t>(vertex)].sink; }

 private:
  // Edges go in pairs, there and back: e and e ^ 1. The first two are not used, so that 0 is no edge.
  enum Parent { kFree = 0, kTerminal = -1, kOrphan = -2 };
  struct Vertex {
    int firstEdge = 0;
    int parent = kFree;  ///< edge towards it, or Parent
    int stamp = 0;       ///< when the distance was last known to hold
    int distance = 0;    ///< to the terminal, in edges
    float pull = 0;      ///< what is left of it
    bool sink = false;   ///< whose tree holds it
    bool active = false;
  };
  struct Edge {
    int to = 0;
    int next = 0;    ///< of the same vertex
    float left = 0;  ///< capacity
  };

  Vertex& at(int vertex) { return m_vertices[static_cast<size_t>(vertex)]; }
  Edge& edge(int index) { return m_edges[static_cast<size_t>(index)]; }
  void activate(int vertex);
  [[nodiscard]] int grow();
  void augment(int meeting);
  void adoptOrphans();
  void adopt(int vertex);
  void release(int vertex);
  [[nodiscard]] int distanceToTerminal(int vertex);

  std::vector<Vertex> m_vertices;
  std::vector<Edge> m_edges;
  std::deque<int> m_active;
  std::vector<int> m_orphans;
  int m_stamp = 0;
};

}  // namespace swaplight
