// Which scheme each of several touching solids is meshed by.
#pragma once

#include <vector>

#include "sweepmesh/pipeline/contacts.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// By solid: the index of one of its schemes.
using SchemeChoice = std::vector<std::size_t>;

/// Choices in the order of trying. `verdicts` by solid, those of solids that take no part are
/// empty. What counts: the schemes' order, and how hard a contact is on them. Two linking faces
/// have the same grid, and two caps can have the same mesh; a cap can take the grid of a linking
/// face if its sweep is from one face to one, hardly if curves are imprinted on it, and not if the
/// caps are meshed by triangles.
std::vector<SchemeChoice> scheme_choices(const std::vector<Assessment>& verdicts,
                                         const std::vector<Contact>& contacts, bool quad_caps);

}  // namespace sweepmesh
