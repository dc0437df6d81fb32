// Whether the transverse edges can carry mesh edges at all.
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/scheme/network.h"

namespace sweepmesh {

/// Around each loop of a linking face as many mesh edges run along +i as along -i (around an
/// annulus: on the outer loop and the hole together). Edges are shared by faces, so all these
/// equations hold at once; this asks whether they do with one mesh edge or more on every edge.
/// (Layers are no matter of this: they exist where level_groups does.) `choices` are decided. A
/// linear program, but for the common case that one mesh edge everywhere will do. Throws
/// SolverError, Cancelled.
bool do_counts_exist(const Network& network, const Choices& choices, Context& context);

}  // namespace sweepmesh
