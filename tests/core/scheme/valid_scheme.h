// What must be true of every scheme, checked from the model alone.
#pragma once

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh::test {

/// Fails the running test where
/// - the sums of types around the loops of a linking face are not 4 and -4 (or 0 and 0 around an
/// annulus),
/// - a type is not the turn between the directions of its coedges,
/// - the two coedges of an edge do not fit (opposite directions; transverse at caps, on the side
/// that the dihedral angle says;
///   no source beside a target) or the edge's role is another,
/// - no layer numbers exist: equal along transverse edges and over each cap, growing along +k.
void expect_valid_scheme(const Model& model, const Scheme& scheme);

}  // namespace sweepmesh::test
