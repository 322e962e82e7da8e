// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/mesh_file.h"

#include "gmsh_elements.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/scene/text_tools.h"

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <fstream>
#include <sstream>

namespace ricochet
{
namespace
{
// The corners of a hexahedron in gmsh's order, as corners x + 2 y + 4 z.
constexpr int gmsh_corner[8] = {0, 1, 3, 2, 4, 5, 7, 6};

std::string contents(const std::filesystem::path &path)
{
  std::ifstream in(path);
  std::ostringstream text;
  if (in)
    text << in.rdbuf();
  if (!in || !text)
    throw FileError("The mesh '" + path.string() +
                    "' cannot be read.\n  Check the name; it is relative to the parameter file.");
  return text.str();
}

void check_format(const std::string &file, const std::string &text)
{
  std::istringstream in(text);
  std::string word, version;
  int is_binary = 1;
  in >> word >> version >> is_binary;
  const std::string remedy = "\n  Save it as 'Version 2 ASCII', or set Mesh.MshFileVersion = 4.1 "
                             "and Mesh.Binary = 0.";
  if (word != "$MeshFormat")
    throw InputError(file +
                     ": This is no gmsh mesh of format 2.2 or 4.1: it does not begin with "
                     "$MeshFormat." +
                     remedy);
  if ((version != "2.2" && version != "4.1") || is_binary != 0)
    throw InputError(file + ": This is gmsh's format " + version +
                     (is_binary ? " binary" : " ASCII") + "; 2.2 and 4.1 ASCII can be read." +
                     remedy);
  if (text.find("$EndElements") == std::string::npos)
    throw InputError(file + ": The mesh cannot be used: it breaks off, $EndElements is "
                            "missing.\n  Save it again.");
  if (has_parametric_nodes(text))
    throw InputError(file +
                     ": The nodes of the mesh carry parameters on curves and surfaces, which "
                     "cannot be read.\n  Set Mesh.SaveParametric = 0.");
}

/// Reads the text into the mesh; file: its name, for errors.
void read_hexahedra(const std::string &file, const std::string &text,
                    dealii::Triangulation<3> &mesh)
{
  std::string problem;
  try
  {
    dealii::GridIn<3> reader(mesh);
    std::istringstream in(text);
    reader.read_msh(in);
  }
  catch (const dealii::ExceptionBase &error)
  {
    std::ostringstream info;
    error.print_info(info);
    problem = squeezed(info.str());
    problem = problem.empty() ? std::string("it is damaged") : problem;
  }
  if (!problem.empty())
    throw InputError(file + ": The mesh cannot be used: " + problem +
                     "\n  It must hold the hexahedra of one body, in one physical volume.");
}

/// Nodes in the order in which cells come upon them.
HexSolid solid_of(const dealii::Triangulation<3> &mesh, const double unit)
{
  HexSolid solid;
  std::vector<int> number(mesh.n_vertices(), -1);
  for (const auto &cell : mesh.active_cell_iterators())
  {
    std::array<int, 8> corners;
    for (int a = 0; a < 8; ++a)
    {
      int &node = number[cell->vertex_index(a)];
      if (node < 0)
      {
        node          = static_cast<int>(solid.nodes.size());
        const auto &x = cell->vertex(a);
        solid.nodes.emplace_back(unit * x[0], unit * x[1], unit * x[2]);
      }
      corners[a] = node;
    }
    solid.cells.push_back(corners);
  }
  return solid;
}

void check_shapes(const std::string &file, const HexSolid &solid, const double unit)
{
  for (std::size_t cell = 0; cell < solid.cells.size(); ++cell)
    if (const double quality = scaled_jacobian(solid, static_cast<int>(cell));
        !(quality >= smallest_scaled_jacobian))
    {
      const Vector3 x = solid.nodes[solid.cells[cell][0]] / unit;
      std::ostringstream message;
      message << file << ": A hexahedron has a scaled Jacobian of " << quality << "; the limit is "
              << smallest_scaled_jacobian << " (1 is a box, "
              << "not above 0 is folded). One of its corners is (" << x.transpose()
              << ").\n  Mesh the body with better elements there.";
      throw InputError(message.str());
    }
}
} // namespace

HexSolid read_mesh(const std::filesystem::path &path, const double unit)
{
  const std::string file = path.string(), text = contents(path);
  check_format(file, text);
  require_hexahedra(file, count_elements(text));
  dealii::Triangulation<3> mesh;
  read_hexahedra(file, text, mesh);
  HexSolid solid = solid_of(mesh, unit);
  check_shapes(file, solid, unit);
  return solid;
}

void write_mesh(const HexSolid &solid, const BodyOfRevolution &body, const double unit,
                std::ostream &out)
{
  const auto surface = surface_of(solid);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
         "$PhysicalNames\n5\n2 1 \"base\"\n2 2 \"shank\"\n2 3 \"nose\"\n2 4 \"plane\"\n"
         "3 1 \"projectile\"\n$EndPhysicalNames\n$Nodes\n"
      << solid.nodes.size() << '\n';
  out.precision(12);
  for (std::size_t node = 0; node < solid.nodes.size(); ++node)
  {
    const Vector3 x = solid.nodes[node] / unit;
    out << node + 1 << ' ' << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
  }
  out << "$EndNodes\n$Elements\n" << surface.size() + solid.cells.size() << '\n';
  std::size_t element = 0;
  for (const auto &quad : surface)
  {
    Vector3 centre = Vector3::Zero();
    bool on_plane  = true;
    for (const int node : quad)
    {
      centre += 0.25 * solid.nodes[node];
      on_plane = on_plane && solid.nodes[node].y() == 0.;
    }
    const int tag = on_plane ? 4 : static_cast<int>(body.hit(centre).surface) + 1;
    out << ++element << " 3 2 " << tag << ' ' << tag;
    for (const int node : quad)
      out << ' ' << node + 1;
    out << '\n';
  }
  for (const auto &corners : solid.cells)
  {
    out << ++element << " 5 2 1 1";
    for (const int corner : gmsh_corner)
      out << ' ' << corners[corner] + 1;
    out << '\n';
  }
  out << "$EndElements\n";
}
} // namespace ricochet
