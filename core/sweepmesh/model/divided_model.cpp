#include "sweepmesh/model/divided_model.h"

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepLib.hxx>
#include <BRepTools_History.hxx>
#include <BRep_Tool.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Surface.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <set>

#include "sweepmesh/model/impl.h"

namespace sweepmesh {
namespace {

[[noreturn]] void fail(const std::string& why) {
  throw Error("divide", "The solid cannot be divided along its rounds: " + why + ".");
}

TopoDS_Edge edge_of(const FaceRecord& face, const FaceCut& cut) {
  const auto own = [&](const Point2& uv) {
    return face.swapped ? gp_Pnt2d(uv.y(), uv.x()) : gp_Pnt2d(uv.x(), uv.y());
  };
  const GCE2d_MakeSegment line(own(cut.from), own(cut.to));
  if (!line.IsDone()) fail("a cut has no length");
  BRepBuilderAPI_MakeEdge edge(line.Value(), BRep_Tool::Surface(face.face));
  if (!edge.IsDone()) fail("a cut does not lie on its face");
  BRepLib::BuildCurves3d(edge.Edge());
  return edge.Edge();
}

using Shapes = std::vector<TopoDS_Shape>;

/// The solid after one step, and what becomes of the shapes before it.
struct Step {
  TopoDS_Shape shape;
  Handle(BRepTools_History) history;

  Shapes images(const TopoDS_Shape& before) const {
    if (history->IsRemoved(before)) return {};
    const TopTools_ListOfShape& modified = history->Modified(before);
    return modified.IsEmpty() ? Shapes{before} : Shapes(modified.begin(), modified.end());
  }
};

Step cut_faces(const Model::Impl& impl, const std::vector<FaceCut>& cuts) {
  TopTools_ListOfShape solids, tools;
  solids.Append(impl.solid);
  for (const FaceCut& cut : cuts) tools.Append(edge_of(impl.faces[cut.face.index], cut));
  BRepAlgoAPI_Splitter splitter;
  splitter.SetArguments(solids);
  splitter.SetTools(tools);
  splitter.SetNonDestructive(true);
  splitter.Build();
  if (!splitter.IsDone() || splitter.HasErrors()) fail("OpenCASCADE cannot cut its faces");
  return {splitter.Shape(), splitter.History()};
}

/// Joins pieces that nothing but a seam divides.
Step join_over(const std::set<EdgeId>& seams, const Model::Impl& impl, const Step& before) {
  TopTools_MapOfShape kept, joined;
  for (const EdgeId seam : seams)
    for (const TopoDS_Shape& piece : before.images(impl.edge_map(seam.index + 1)))
      joined.Add(piece);
  for (TopExp_Explorer it(before.shape, TopAbs_EDGE); it.More(); it.Next())
    if (!joined.Contains(it.Current())) kept.Add(it.Current());
  ShapeUpgrade_UnifySameDomain join(before.shape, false, true, false);
  join.KeepShapes(kept);
  join.Build();
  return {join.Shape(), join.History()};
}

/// The seam that a cut runs along, if it does.
EdgeId seam_along(const Model& model, const FaceCut& cut) {
  const Point3 middle = model.point(cut.face, 0.5 * (cut.from + cut.to));
  for (const Loop& loop : model.loops(cut.face))
    for (const Coedge& c : loop)
      if (c.seam && model.distance(c.edge, middle) < model.tolerances().point) return c.edge;
  return {};
}

/// Cuts that are not there already, and the seams of their faces that no cut runs along.
struct Task {
  std::vector<FaceCut> cuts;
  std::set<EdgeId> seams;
};

Task task_of(const Model& model, const std::vector<FaceCut>& cuts) {
  Task out;
  for (const FaceCut& cut : cuts)
    for (const Loop& loop : model.loops(cut.face))
      for (const Coedge& c : loop)
        if (c.seam) out.seams.insert(c.edge);
  for (const FaceCut& cut : cuts)
    if (const EdgeId seam = seam_along(model, cut); seam.is_valid())
      out.seams.erase(seam);
    else
      out.cuts.push_back(cut);
  return out;
}

/// By id in the divided solid: the index of what it is a part of in the undivided one, or -1.
template <class Id>
std::vector<int> origins(const std::vector<Id>& ids, const TopTools_IndexedMapOfShape& before,
                         const TopTools_IndexedMapOfShape& after, const std::vector<Step>& steps) {
  std::vector<int> out(after.Extent(), -1);
  for (const Id id : ids) {
    Shapes shapes = {before(id.index + 1)};
    for (const Step& step : steps) {
      Shapes next;
      for (const TopoDS_Shape& shape : shapes)
        for (const TopoDS_Shape& image : step.images(shape)) next.push_back(image);
      shapes = std::move(next);
    }
    for (const TopoDS_Shape& shape : shapes)
      if (const int i = after.FindIndex(shape); i > 0) out[i - 1] = id.index;
  }
  return out;
}

/// What the new edges and vertices lie on, from what their neighbours are parts of.
void find_owners(DividedModel& out) {
  const Model& m = out.model;
  out.edge_face.resize(out.edge.size());
  out.vertex_edge.resize(out.vertex.size());
  for (const EdgeId e : m.edges()) {
    if (!out.edge[e.index].is_valid())
      out.edge_face[e.index] = out.face[m.coedges(e).front().face.index];
    for (const VertexId v : {m.start(e), m.end(e)})
      if (!out.vertex[v.index].is_valid() && out.edge[e.index].is_valid())
        out.vertex_edge[v.index] = out.edge[e.index];
  }
}

void check(const Model& model, const DividedModel& divided) {
  constexpr double kSameVolume = 1e-6;
  const Model& m = divided.model;
  if (std::abs(m.volume() - model.volume()) > kSameVolume * model.volume())
    fail("its volume is not kept");
  for (const FaceId f : m.faces())
    if (!divided.face[f.index].is_valid())
      fail("a face of the divided solid is none of the others");
  for (const VertexId v : m.vertices())
    if (!divided.vertex[v.index].is_valid() && !divided.vertex_edge[v.index].is_valid())
      fail("a cut ends inside of a face");
}

std::shared_ptr<const Model::Impl> read_back(const TopoDS_Shape& shape) try {
  return make_impl(shape, 0);
} catch (const InputError&) {
  fail("what the cuts leave is not a solid");
}

template <class Id>
std::vector<Id> as_ids(const std::vector<int>& indices) {
  std::vector<Id> out;
  for (const int i : indices) out.emplace_back(i);
  return out;
}

}  // namespace

DividedModel divide_model(const Model& model, const std::vector<FaceCut>& cuts) {
  return translated("The solid cannot be divided along its rounds", [&] {
    const Model::Impl& impl = model.impl();
    const Task task = task_of(model, cuts);
    std::vector<Step> steps = {cut_faces(impl, task.cuts)};
    steps.push_back(join_over(task.seams, impl, steps.front()));
    const auto made = read_back(steps.back().shape);
    DividedModel out{Model(made), {}, {}, {}, {}, {}};
    out.face = as_ids<FaceId>(origins(model.faces(), impl.face_map, made->face_map, steps));
    out.edge = as_ids<EdgeId>(origins(model.edges(), impl.edge_map, made->edge_map, steps));
    out.vertex =
        as_ids<VertexId>(origins(model.vertices(), impl.vertex_map, made->vertex_map, steps));
    find_owners(out);
    check(model, out);
    return out;
  });
}

}  // namespace sweepmesh
