#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_SequenceOfPrinters.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>
#include <ShapeAlgo_ToolContainer.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Wire.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "sweepmesh/model/impl.h"

namespace sweepmesh {
namespace {

/// Keeps OpenCASCADE's readers from writing to the terminal while it lives.
class SilentMessenger {
 public:
  SilentMessenger() : kept_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~SilentMessenger() { Message::DefaultMessenger()->ChangePrinters() = kept_; }
  SilentMessenger(const SilentMessenger&) = delete;
  SilentMessenger& operator=(const SilentMessenger&) = delete;

 private:
  Message_SequenceOfPrinters kept_;
};

/// Makes OpenCASCADE's tool that heals what it reads, without its search for loops that intersect
/// themselves.
class QuickTools : public ShapeAlgo_ToolContainer {
 public:
  Handle(ShapeFix_Shape) FixShape() const override {
    Handle(ShapeFix_Shape) fix = ShapeAlgo_ToolContainer::FixShape();
    fix->FixWireTool()->FixSelfIntersectionMode() = 0;
    return fix;
  }
};

/// Sets these tools while it lives.
class QuickHealing {
 public:
  QuickHealing() : kept_(ShapeAlgo::AlgoContainer()->ToolContainer()) {
    ShapeAlgo::AlgoContainer()->SetToolContainer(new QuickTools);
  }
  ~QuickHealing() { ShapeAlgo::AlgoContainer()->SetToolContainer(kept_); }
  QuickHealing(const QuickHealing&) = delete;
  QuickHealing& operator=(const QuickHealing&) = delete;

 private:
  Handle(ShapeAlgo_ToolContainer) kept_;
};

/// The search takes the cube of a loop's edges: 15 seconds for 2000.
bool has_long_loop(const Interface_InterfaceModel& file) {
  constexpr int many_edges = 400;
  for (int i = 1; i <= file.NbEntities(); ++i) {
    const auto loop = Handle(StepShape_EdgeLoop)::DownCast(file.Value(i));
    if (!loop.IsNull() && loop->NbEdgeList() > many_edges) return true;
  }
  return false;
}

template <class Reader>
TopoDS_Shape read_exchange_file(const std::string& path, const char* format) {
  Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw InputError("read", "The file " + path + " is not a readable " + format + " file.");
  std::optional<QuickHealing> quick;
  if (has_long_loop(*reader.Model())) quick.emplace();
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull())
    throw InputError("read", "The " + std::string(format) + " file " + path + " holds no shape.");
  return shape;
}

bool has(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  return TopExp_Explorer(shape, kind).More();
}

/// IGES files mostly hold loose trimmed surfaces: sewn to closed shells they bound solids.
TopoDS_Shape sewn(const TopoDS_Shape& shape) {
  if (has(shape, TopAbs_SOLID) || !has(shape, TopAbs_FACE)) return shape;
  BRepBuilderAPI_Sewing sewing(1e-3);
  sewing.Add(shape);
  sewing.Perform();
  BRepBuilderAPI_MakeSolid solid;
  bool any = false;
  for (TopExp_Explorer it(sewing.SewedShape(), TopAbs_SHELL); it.More(); it.Next()) {
    if (!BRep_Tool::IsClosed(it.Current())) return sewing.SewedShape();
    solid.Add(TopoDS::Shell(it.Current()));
    any = true;
  }
  return any ? TopoDS_Shape(solid.Solid()) : sewing.SewedShape();
}

/// `source` begins the sentence where the text is none. The reader would complain on standard
/// output.
TopoDS_Shape read_brep(std::istream& stream, const std::string& source) {
  TopoDS_Shape shape;
  BRep_Builder builder;
  std::string line;
  while (std::getline(stream, line) && line.empty()) {
  }
  const bool has_header = line.rfind("DBRep_DrawableShape", 0) == 0;
  const bool has_version = line.rfind("CASCADE Topology", 0) == 0;
  if (has_header || has_version) {
    stream.clear();
    stream.seekg(0);
    BRepTools::Read(shape, stream, builder);
  }
  if (shape.IsNull()) throw InputError("read", source + " is not readable BREP text.");
  return shape;
}

}  // namespace

TopoDS_Shape read_shape_file(const std::string& path) {
  const std::filesystem::path file(path);
  if (!std::filesystem::is_regular_file(file))
    throw InputError("read", "There is no file " + path + ".");
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const SilentMessenger silent;
  return translated("The file " + path + " cannot be read", [&]() -> TopoDS_Shape {
    if (suffix == ".step" || suffix == ".stp")
      return read_exchange_file<STEPControl_Reader>(path, "STEP");
    if (suffix == ".iges" || suffix == ".igs")
      return sewn(read_exchange_file<IGESControl_Reader>(path, "IGES"));
    if (suffix == ".brep" || suffix == ".brp") {
      std::ifstream stream(path);
      return read_brep(stream, "The file " + path);
    }
    throw InputError("read", "The file " + path +
                                 " has none of the suffixes that can be read (.step, .stp, .brep, "
                                 ".brp, .iges, .igs).");
  });
}

TopoDS_Shape read_brep_text(const std::string& text) {
  return translated("The shape cannot be read", [&]() -> TopoDS_Shape {
    std::istringstream stream(text);
    return read_brep(stream, "The shape");
  });
}

}  // namespace sweepmesh
