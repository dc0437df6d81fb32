// Places on CAD edges as fractions of their length, and back.
#pragma once

#include <vector>

#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// Fraction of the edge's length, 0..1, at each of the curve parameters (which lie in its range):
/// from a table of the inverse, exact to about 1e-4 of the length between its entries.
std::vector<double> length_fractions(const Model& model, EdgeId e, const std::vector<double>& t);

/// n + 1 parameters from `first` to `last` (in either order), evenly spaced in length.
std::vector<double> even_parameters(const Model& model, EdgeId e, double first, double last, int n);

}  // namespace sweepmesh
