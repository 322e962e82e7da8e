// SPDX-License-Identifier: LGPL-2.1-or-later
#include "gmsh_elements.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/text_tools.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

namespace ricochet
{
namespace
{
/// One of gmsh's types, or a range of them.
struct Kind
{
  int first, last; // type
  int dimension;
  int order;                 // 3: third or higher
  const char *one, *several; // of the shape
};

// The table of element types in gmsh's manual (chapter on file formats), and for orders above three
// GmshDefines.h of its source.
constexpr Kind kinds[] = {
    {15, 15, 0, 1, "point", "points"},
    {1, 1, 1, 1, "line", "lines"},
    {8, 8, 1, 2, "line", "lines"},
    {26, 28, 1, 3, "line", "lines"},
    {2, 2, 2, 1, "triangle", "triangles"},
    {9, 9, 2, 2, "triangle", "triangles"},
    {20, 25, 2, 3, "triangle", "triangles"},
    {3, 3, 2, 1, "quadrangle", "quadrangles"},
    {10, 10, 2, 2, "quadrangle", "quadrangles"},
    {16, 16, 2, 2, "quadrangle", "quadrangles"},
    {36, 41, 2, 3, "quadrangle", "quadrangles"},
    {4, 4, 3, 1, "tetrahedron", "tetrahedra"},
    {11, 11, 3, 2, "tetrahedron", "tetrahedra"},
    {29, 33, 3, 3, "tetrahedron", "tetrahedra"},
    {5, 5, 3, 1, "hexahedron", "hexahedra"},
    {12, 12, 3, 2, "hexahedron", "hexahedra"},
    {17, 17, 3, 2, "hexahedron", "hexahedra"},
    {92, 105, 3, 3, "hexahedron", "hexahedra"},
    {6, 6, 3, 1, "prism", "prisms"},
    {13, 13, 3, 2, "prism", "prisms"},
    {18, 18, 3, 2, "prism", "prisms"},
    {90, 91, 3, 3, "prism", "prisms"},
    {106, 117, 3, 3, "prism", "prisms"},
    {7, 7, 3, 1, "pyramid", "pyramids"},
    {14, 14, 3, 2, "pyramid", "pyramids"},
    {19, 19, 3, 2, "pyramid", "pyramids"},
    {118, 132, 3, 3, "pyramid", "pyramids"},
};

/// nullptr for a type that is not in the table.
const Kind *kind_of(const int type)
{
  const auto found =
      std::find_if(std::begin(kinds), std::end(kinds),
                   [type](const Kind &kind) { return kind.first <= type && type <= kind.last; });
  return found == std::end(kinds) ? nullptr : found;
}

/// What is unknown is taken for a volume.
int dimension_of(const int type)
{
  const Kind *const kind = kind_of(type);
  return kind ? kind->dimension : 3;
}

bool is_hexahedron(const Kind &kind)
{
  return kind.one == std::string("hexahedron");
}

/// Of first order, and a hexahedron or what may bound one.
bool is_usable(const int type)
{
  const Kind *const kind = kind_of(type);
  return kind && kind->order == 1 &&
         (is_hexahedron(*kind) || (kind->dimension < 3 && kind->one != std::string("triangle")));
}

/// "192 second-order hexahedra".
std::string in_words(const int type, const long count)
{
  const Kind *const kind = kind_of(type);
  if (!kind)
    return std::to_string(count) + " elements of gmsh's type " + std::to_string(type);
  return std::to_string(count) + (kind->order == 2 ? " second-order " : " ") +
         (count == 1 ? kind->one : kind->several) + (kind->order > 2 ? " of higher order" : "");
}

/// "3 a, 2 b and 1 c".
std::string in_words(const GmshElementCounts &counts)
{
  std::vector<std::string> words;
  for (const auto &[type, count] : counts)
    words.push_back(in_words(type, count));
  return joined(words, " and ");
}

template <class Condition>
GmshElementCounts those(const GmshElementCounts &counts, Condition &&condition)
{
  GmshElementCounts result;
  for (const auto &entry : counts)
    if (condition(entry.first))
      result.insert(entry);
  return result;
}

/// The settings of gmsh that turn these elements into usable ones.
std::string remedy(const GmshElementCounts &unusable)
{
  bool high_order = false, other_shape = false;
  for (const auto &[type, count] : unusable)
  {
    const Kind *const kind = kind_of(type);
    high_order             = high_order || (kind && kind->order > 1);
    other_shape            = other_shape || !kind || !is_hexahedron(*kind);
  }
  std::string text;
  if (high_order)
    text += "\n  Set Mesh.ElementOrder = 1 and mesh again.";
  if (other_shape)
    text += "\n  Set Mesh.RecombineAll = 1 and extrude with 'Recombine', or use transfinite "
            "volumes; or set Mesh.SubdivisionAlgorithm = 2, which cuts all elements into "
            "hexahedra.";
  return text;
}

/// Moves behind the line that opens a section; false if there is none.
bool find_section(std::istream &in, const std::string &name)
{
  for (std::string line; std::getline(in, line);)
    if (squeezed(line) == name)
      return true;
  return false;
}

bool is_version_4(std::istream &in)
{
  double version = 0.;
  return find_section(in, "$MeshFormat") && in >> version && version >= 4.;
}

void skip_lines(std::istream &in, const long n)
{
  for (long i = 0; i < n && in; ++i)
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
}

/// "number type ..." in each line.
GmshElementCounts count_lines(std::istream &in)
{
  GmshElementCounts counts;
  long n = 0, number = 0;
  int type = 0;
  in >> n;
  for (long i = 0; i < n && in >> number >> type; ++i)
  {
    ++counts[type];
    skip_lines(in, 1);
  }
  return counts;
}

/// Blocks of one type each: "dimension tag type count" and as many lines.
GmshElementCounts count_blocks(std::istream &in)
{
  GmshElementCounts counts;
  long n_blocks = 0, dimension = 0, tag = 0, count = 0;
  int type = 0;
  in >> n_blocks;
  skip_lines(in, 1);
  for (long block = 0; block < n_blocks && in >> dimension >> tag >> type >> count; ++block)
  {
    counts[type] += count;
    skip_lines(in, count + 1);
  }
  return counts;
}
} // namespace

GmshElementCounts count_elements(const std::string &text)
{
  std::istringstream in(text);
  const bool blocks = is_version_4(in);
  if (!find_section(in, "$Elements"))
    return {};
  return blocks ? count_blocks(in) : count_lines(in);
}

bool has_parametric_nodes(const std::string &text)
{
  std::istringstream in(text);
  if (!is_version_4(in))
    return find_section(in, "$ParametricNodes");
  if (!find_section(in, "$Nodes"))
    return false;
  long n_blocks = 0, dimension = 0, tag = 0, parametric = 0, count = 0;
  in >> n_blocks;
  skip_lines(in, 1);
  // Of each block "dimension tag parametric count", as many numbers and as many places.
  for (long block = 0; block < n_blocks && in >> dimension >> tag >> parametric >> count; ++block)
  {
    if (parametric != 0)
      return true;
    skip_lines(in, 2 * count + 1);
  }
  return false;
}

void require_hexahedra(const std::string &file, const GmshElementCounts &counts)
{
  const auto volumes  = those(counts, [](const int type) { return dimension_of(type) == 3; });
  const auto unusable = those(counts, [](const int type) { return !is_usable(type); });
  if (volumes.empty())
    throw InputError(file + ": The mesh holds no volume elements" +
                     (counts.empty() ? "" : ", only " + in_words(counts)) +
                     ".\n  Mesh the volume ('gmsh -3') with hexahedra and put it into a physical "
                     "volume, or set Mesh.SaveAll = 1.");
  if (unusable.empty())
    return;
  const auto unusable_volumes =
      those(unusable, [](const int type) { return dimension_of(type) == 3; });
  throw InputError(
      file + ": The mesh holds " +
      (unusable_volumes.empty() ? in_words(unusable) + " among its surfaces" : in_words(volumes)) +
      "; only hexahedra with 8 nodes can be used." +
      remedy(unusable_volumes.empty() ? unusable : unusable_volumes));
}
} // namespace ricochet
