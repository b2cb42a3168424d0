// SPDX-License-Identifier: Apache-2.0
#include "engine/roofs/least_cut.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

namespace ilot {
namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
struct Node {
  std::size_t index = 0;
  boost::default_color_type colour{};
  long distance = 0;
  Traits::edge_descriptor predecessor;
};
struct Arc {
  std::int64_t capacity = 0, residual = 0;
  Traits::edge_descriptor reverse;
};
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, Node, Arc>;

void connect(Graph& graph, std::size_t from, std::size_t to, std::int64_t capacity) {
  const auto arc = boost::add_edge(from, to, graph).first;
  const auto back = boost::add_edge(to, from, graph).first;
  graph[arc].capacity = capacity;
  graph[arc].reverse = back;
  graph[back].reverse = arc;
}

// Who can still reach the sink.
std::vector<std::uint8_t> sink_side(const Graph& graph, std::size_t sink) {
  std::vector<std::uint8_t> reached(boost::num_vertices(graph), 0);
  std::vector<std::size_t> stack{sink};
  reached[sink] = 1;
  while (!stack.empty()) {
    const std::size_t v = stack.back();
    stack.pop_back();
    const auto [first, last] = boost::out_edges(v, graph);
    for (auto e = first; e != last; ++e) {
      const std::size_t u = boost::target(*e, graph);
      if (reached[u] || graph[graph[*e].reverse].residual == 0) continue;
      reached[u] = 1;
      stack.push_back(u);
    }
  }
  return reached;
}

}  // namespace

std::vector<std::uint8_t> least_cut(std::span<const std::int64_t> gain, std::span<const CutArc> arcs) {
  const std::size_t source = gain.size(), sink = source + 1;
  Graph graph(gain.size() + 2);
  for (std::size_t i = 0; i < gain.size() + 2; ++i) graph[i].index = i;
  for (const CutArc& arc : arcs) connect(graph, arc.from, arc.to, arc.capacity);
  for (std::size_t i = 0; i < gain.size(); ++i) {
    if (gain[i] > 0) connect(graph, source, i, gain[i]);
    if (gain[i] < 0) connect(graph, i, sink, -gain[i]);
  }
  boost::boykov_kolmogorov_max_flow(graph, boost::get(&Arc::capacity, graph), boost::get(&Arc::residual, graph),
                                    boost::get(&Arc::reverse, graph), boost::get(&Node::predecessor, graph),
                                    boost::get(&Node::colour, graph), boost::get(&Node::distance, graph),
                                    boost::get(&Node::index, graph), source, sink);
  std::vector<std::uint8_t> goes = sink_side(graph, sink);
  goes.resize(gain.size());
  return goes;
}

}  // namespace ilot
