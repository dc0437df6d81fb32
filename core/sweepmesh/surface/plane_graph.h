// A plane graph as the order of edges around each node.
//
// A dart is an edge seen from one of its ends; its twin is the same edge from the other. Around
// each node darts are kept counterclockwise, which tells the faces: the next dart of the face on
// the left of a dart is the one before its twin around the node that it leads to. No places are
// needed.
#pragma once

#include <vector>

namespace sweepmesh {

class PlaneGraph {
 public:
  /// Nodes 0 .. n_kept - 1 always stay.
  PlaneGraph(int n_nodes, int n_kept) : n_kept_(n_kept), around_(n_nodes) {}

  /// The dart from a to b; the one from b to a has the next number. Both have yet to be placed.
  int add_edge(int a, int b);
  /// Behind those that its node has, counterclockwise.
  void place(int dart) { around_[origin_[dart]].push_back(dart); }

  int n_nodes() const { return static_cast<int>(around_.size()); }
  int n_darts() const { return static_cast<int>(origin_.size()); }
  int valence(int node) const { return static_cast<int>(around_[node].size()); }
  int origin(int dart) const { return origin_[dart]; }
  int twin(int dart) const { return twin_[dart]; }
  bool is_alive(int dart) const;
  /// The next dart around the face on the left.
  int next(int dart) const;

  /// Takes the edge away.
  void remove(int dart);
  /// Takes away nodes with one edge with it, and passes over those with two, until all others that
  /// need not stay have three or none. Linear.
  void simplify();
  /// Makes one node, that of the first dart, of a face's corners, each of which has three edges or
  /// more; the darts are the face's.
  void contract(const std::vector<int>& darts);

  /// Flags the nodes that can be reached from those given.
  std::vector<char> reached_from(std::vector<int> front) const;
  /// Takes away all edges of the nodes that are not flagged.
  void clear_unreached(const std::vector<char>& is_reached);

 private:
  const int n_kept_;
  std::vector<int> origin_, twin_;
  std::vector<std::vector<int>> around_;
};

}  // namespace sweepmesh
