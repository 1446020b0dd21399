// SPDX-License-Identifier: MIT
#include "formats/point_formats.h"

#include "core/table_text.h"

namespace freshet {
namespace {

constexpr PointFormat formats[] = {
    {".csv", read_csv},     {".ply", read_ply}, {".vtk", read_vtk},   {".vtp", read_vtk_xml},
    {".vtu", read_vtk_xml}, {".xyz", read_xyz}, {".bgeo", read_bgeo}, {".bhclassic", read_bgeo},
};

constexpr const char* by_paraview = "in ParaView, save it with File > Save Data as *.vtp or *.vtu";
constexpr const char* by_houdini = "in Houdini, save it as *.bhclassic or *.ply";
constexpr const char* by_partio = "convert it with partconv, which writes *.bgeo";
constexpr const char* by_ovito = "in OVITO, export it as *.xyz with named columns";
constexpr const char* by_cloud_compare = "in CloudCompare, save it as *.ply";
constexpr const char* by_spreadsheet = "in the spreadsheet, save it as *.csv";
constexpr const char* a_mesh = "a mesh needs shape = \"mesh\"; points are exported as *.ply";
constexpr const char* by_pandas =
    "write its arrays as *.csv with a line of names, for example with pandas";

/// Formats of other programs, and the export that is closest to them.
constexpr struct {
  const char* extension;
  const char* remedy;
} others[] = {
    {".pvd", "name one of the *.vtp or *.vtu files that it lists"},
    {".pvtp", by_paraview},
    {".pvtu", by_paraview},
    {".vtm", by_paraview},
    {".vts", by_paraview},
    {".vtr", by_paraview},
    {".vti", by_paraview},
    {".vtkhdf", by_paraview},
    {".foam", by_paraview},
    {".case", by_paraview},
    {".bi4", "convert it with PartVTK of DualSPHysics, which writes *.vtk"},
    {".geo", by_houdini},
    {".sc", by_houdini},
    {".abc", "in Houdini or Blender, export it as *.ply"},
    {".prt", by_partio},
    {".pdb", by_partio},
    {".pdc", by_partio},
    {".gz", "unpack it with gunzip"},
    {".dump", by_ovito},
    {".lammpstrj", by_ovito},
    {".gsd", by_ovito},
    {".pcd", "convert it with pcl_pcd2ply, which writes *.ply"},
    {".las", by_cloud_compare},
    {".laz", by_cloud_compare},
    {".e57", by_cloud_compare},
    {".stl", a_mesh},
    {".obj", a_mesh},
    {".npy", by_pandas},
    {".npz", by_pandas},
    {".hdf5", by_pandas},
    {".h5", "write its arrays as *.csv; a run writes *.vtp with output.data = [\"vtp\"]"},
    {".xlsx", by_spreadsheet},
    {".ods", by_spreadsheet},
    {".txt", "rename it to *.csv if a line names its columns, else to *.xyz"},
    {".dat", "rename it to *.csv if a line names its columns, else to *.xyz"},
};

template <class List> auto* entry_of(const List& list, const std::filesystem::path& file) {
  const std::string extension = plain_name(file.extension().string());
  const auto it = std::find_if(std::begin(list), std::end(list),
                               [&](const auto& entry) { return extension == entry.extension; });
  return it == std::end(list) ? nullptr : &*it;
}

}  // namespace

std::span<const PointFormat> point_formats() { return formats; }

const PointFormat* point_format_of(const std::filesystem::path& file) {
  return entry_of(formats, file);
}

std::string point_extensions() {
  std::string list;
  for (const PointFormat& format : formats) {
    if (!list.empty()) list += &format == std::end(formats) - 1 ? " or " : ", ";
    list += std::string("*") + format.extension;
  }
  return list;
}

std::string other_format_remedy(const std::filesystem::path& file) {
  const auto* known = entry_of(others, file);
  return known ? known->remedy : "convert it to *.csv or *.ply";
}

}  // namespace freshet
