#include "core/shadow/numeric/cut_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace swaplight {
namespace {

constexpr int kUnreached = std::numeric_limits<int>::max();

}  // namespace

CutGraph::CutGraph(int vertices, int links) : m_vertices(static_cast<size_t>(vertices)), m_edges(2) {
  m_edges.reserve(2 * static_cast<size_t>(links) + 2);
}

void CutGraph::link(int a, int b, float cost) {
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    m_edges.push_back({to, at(from).firstEdge, cost});
    at(from).firstEdge = static_cast<int>(m_edges.size()) - 1;
  }
}

void CutGraph::solve() {
  for (int i = 0; i < static_cast<int>(m_vertices.size()); ++i) {
    Vertex& vertex = at(i);
    if (vertex.pull == 0) continue;
    vertex.parent = kTerminal;
    vertex.distance = 1;
    vertex.sink = vertex.pull < 0;
    activate(i);
  }
  while (const int meeting = grow()) {
    augment(meeting);
    adoptOrphans();
  }
}

void CutGraph::activate(int vertex) {
  if (at(vertex).active) return;
  at(vertex).active = true;
  m_active.push_back(vertex);
}

/// Grows both trees until they meet: the edge from the source's to the sink's, or 0 where they cannot.
int CutGraph::grow() {
  while (!m_active.empty()) {
    Vertex& vertex = at(m_active.front());
    for (int e = vertex.parent != kFree ? vertex.firstEdge : 0; e != 0; e = edge(e).next) {
      if (edge(e ^ int{vertex.sink}).left == 0) continue;
      Vertex& other = at(edge(e).to);
      if (other.parent != kFree && other.sink != vertex.sink) return e ^ int { vertex.sink };
      const bool isNew = other.parent == kFree;
      if (!isNew && !(other.distance > vertex.distance + 1 && other.stamp <= vertex.stamp)) continue;
      other.sink = vertex.sink;
      other.parent = e ^ 1;
      other.stamp = vertex.stamp;
      other.distance = vertex.distance + 1;
      if (isNew) activate(edge(e).to);
    }
    vertex.active = false;
    m_active.pop_front();
  }
  return 0;
}

/// Pushes what the path through an edge bears. What then hangs on a full edge, or on a pull that is used up,
/// is an orphan.
void CutGraph::augment(int meeting) {
  // In the source's tree flow goes from the parent, in the sink's to it.
  struct Half {
    int start, towards;
  };
  const Half halves[] = {{edge(meeting ^ 1).to, 1}, {edge(meeting).to, 0}};
  float flow = edge(meeting).left;
  for (const auto& [start, towards] : halves) {
    int v = start;
    for (; at(v).parent > 0; v = edge(at(v).parent).to)
      flow = std::min(flow, edge(at(v).parent ^ towards).left);
    flow = std::min(flow, std::abs(at(v).pull));
  }
  edge(meeting).left -= flow;
  edge(meeting ^ 1).left += flow;
  const auto orphan = [&](int v) {
    m_orphans.push_back(v);
    at(v).parent = kOrphan;
  };
  for (const auto& [start, towards] : halves) {
    int v = start;
    for (int e = at(v).parent; e > 0; e = at(v).parent) {
      const int child = v;
      v = edge(e).to;
      edge(e ^ towards ^ 1).left += flow;
      if ((edge(e ^ towards).left -= flow) == 0) orphan(child);
    }
    at(v).pull += towards ? -flow : flow;
    if (at(v).pull == 0) orphan(v);
  }
}

void CutGraph::adoptOrphans() {
  ++m_stamp;
  while (!m_orphans.empty()) {
    const int vertex = m_orphans.back();
    m_orphans.pop_back();
    adopt(vertex);
  }
}

/// Edges to the terminal of the tree that holds a vertex; kUnreached where the way ends at an orphan.
int CutGraph::distanceToTerminal(int vertex) {
  for (int steps = 0;; ++steps, vertex = edge(at(vertex).parent).to) {
    Vertex& here = at(vertex);
    if (here.stamp == m_stamp) return steps + here.distance;
    if (here.parent == kOrphan) return kUnreached;
    if (here.parent != kTerminal) continue;
    here.stamp = m_stamp;
    here.distance = 1;
    return steps + 1;
  }
}

/// Hangs an orphan on the neighbour of its tree that is nearest to the terminal.
void CutGraph::adopt(int vertex) {
  Vertex& orphan = at(vertex);
  int best = kFree;
  int shortest = kUnreached;
  for (int e = orphan.firstEdge; e != 0; e = edge(e).next) {
    if (edge(e ^ int{!orphan.sink}).left == 0) continue;
    const int neighbour = edge(e).to;
    if (at(neighbour).sink != orphan.sink || at(neighbour).parent == kFree) continue;
    const int distance = distanceToTerminal(neighbour);
    if (distance == kUnreached) continue;
    if (distance + 1 < shortest) {
      shortest = distance + 1;
      best = e;
    }
    int left = distance;
    for (int v = neighbour; at(v).stamp != m_stamp; v = edge(at(v).parent).to) {
      at(v).stamp = m_stamp;
      at(v).distance = left--;
    }
  }
  orphan.parent = best;
  if (best == kFree) return release(vertex);
  orphan.stamp = m_stamp;
  orphan.distance = shortest;
}

/// No tree holds an orphan any more: its children are orphans too, its neighbours may grow to it.
void CutGraph::release(int vertex) {
  const bool sink = at(vertex).sink;
  at(vertex).stamp = 0;
  for (int e = at(vertex).firstEdge; e != 0; e = edge(e).next) {
    const int neighbour = edge(e).to;
    const int parent = at(neighbour).parent;
    if (at(neighbour).sink != sink || parent == kFree) continue;
    if (edge(e ^ int{!sink}).left != 0) activate(neighbour);
    if (parent > 0 && edge(parent).to == vertex) {
      m_orphans.push_back(neighbour);
      at(neighbour).parent = kOrphan;
    }
  }
}

}  // namespace swaplight
