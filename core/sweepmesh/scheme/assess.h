// Can this solid be swept, which way, and if not, why?
#pragma once

#include <variant>

#include "sweepmesh/base/context.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Every valid division of the solid's faces into sources, targets and linking faces that is among
/// the cheapest (to_scheme.h says what is ranked before what), or the reasons why there is none. No
/// mesh is made.
///
/// Picked sources and targets keep their roles; other faces take any. Where both were picked,
/// schemes with no other caps come first. A face with a picked vertex type is a linking face, and
/// the type holds wherever its loops pass the vertex; types that cannot hold together are a reason
/// that names them. Throws InputError for a picked face that is not of this solid, a vertex that is
/// not of its face or has two types there, and types on a picked cap; Cancelled. Never fails on an
/// odd solid: what is not understood becomes a reason. The search is cut off after a fixed effort
/// (about two seconds); that is a reason too where nothing was found by then. Source: thesis
/// chapter 7.
Assessment assess(const Model& model, const Picks& picks, Context& context);

/// Schemes of a solid without picks that are possible within the lenient limits (limits.h), no two
/// with the same caps: what is left to try where none of those of assess() can be laid out.
/// Ascending cost. Throws Cancelled. The search is cut off as that of assess().
std::vector<Scheme> strained_schemes(const Model& model, Context& context);

/// The cheapest directions and types where the role of every face is given (indexed by FaceId), or
/// the reasons against.
std::variant<Scheme, std::vector<Reason>> solve_scheme(const Model& model,
                                                       const std::vector<FaceRole>& roles,
                                                       Context& context);

}  // namespace sweepmesh
