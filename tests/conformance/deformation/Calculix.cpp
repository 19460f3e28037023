#include "Calculix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace insonate::test {
namespace {

using Place = std::array<double, 2>;
constexpr double kOn_mm = 1e-6, kGrowth = 1.3;

/// Corner nodes on a lattice of a millimeter, moved onto the circles; then elements with nodes in the middle of edges.
class Mesh {
 public:
  struct Element {
    std::vector<int> nodes;  ///< corners, then middles
    int material = 0;        ///< 0 tissue, else circle + 1
  };
  std::vector<Place> places;
  std::vector<Element> elements;
  /// Edges of a hollow circle: element, its face, the ends and the middle.
  struct Hole {
    int element, face;
    std::array<int, 3> nodes;
  };
  std::vector<std::vector<Hole>> holes;

  explicit Mesh(const CalculixBlock& block) : holes(block.circles.size()), block_(block) {
    const std::vector<double> across = lattice(block);
    columns_ = static_cast<int>(across.size());
    rows_ = static_cast<int>(block.height_mm) + 1;
    for (int j = 0; j < rows_; ++j)
      for (const double x : across) places.push_back(snapped({x, double(j)}));
    for (int j = 0; j + 1 < rows_; ++j)
      for (int i = 0; i + 1 < columns_; ++i) {
        const int n = j * columns_ + i;
        addCell({n, n + columns_, n + 1 + columns_, n + 1});
      }
    dropUnused();
  }

 private:
  /// A millimeter apart in the middle, then growing to where the sides are.
  static std::vector<double> lattice(const CalculixBlock& block) {
    std::vector<double> right;
    for (double x = 0, step = 1; x < block.sides_mm; x += step) {
      right.push_back(x);
      if (x >= block.width_mm / 2) step *= kGrowth;
    }
    if (block.sides_mm - right.back() < 1) right.pop_back();
    right.push_back(block.sides_mm);
    std::vector<double> all;
    for (std::size_t i = right.size() - 1; i > 0; --i) all.push_back(-right[i]);
    all.insert(all.end(), right.begin(), right.end());
    return all;
  }

  double distance(const Place& p, std::size_t circle) const {
    const auto& c = block_.circles[circle];
    return std::hypot(p[0] - c.x_mm, p[1] - c.z_mm) - c.radius_mm;
  }

  Place projected(const Place& p, std::size_t circle) const {
    const auto& c = block_.circles[circle];
    const double scale = c.radius_mm / std::hypot(p[0] - c.x_mm, p[1] - c.z_mm);
    return {c.x_mm + scale * (p[0] - c.x_mm), c.z_mm + scale * (p[1] - c.z_mm)};
  }

  /// Moves the nearer end of an edge that crosses a circle onto it.
  Place snapped(const Place& p) const {
    for (std::size_t c = 0; c < block_.circles.size(); ++c)
      if (std::abs(distance(p, c)) < 0.501) return projected(p, c);
    return p;
  }

  /// A circle that has corners of the cell on both sides, and the first corner on it.
  void addCell(const std::array<int, 4>& corners) {
    for (std::size_t c = 0; c < block_.circles.size(); ++c) {
      bool inside = false, outside = false;
      std::array<bool, 4> on{};
      for (int k = 0; k < 4; ++k) {
        const double d = distance(places[corners[k]], c);
        on[k] = std::abs(d) < kOn_mm;
        inside |= d < -kOn_mm;
        outside |= d > kOn_mm;
      }
      if (!inside || !outside) continue;
      const int first = on[0] && on[2] ? 0 : 1;
      addElement({corners[first], corners[first + 1], corners[first + 2]});
      addElement({corners[first], corners[first + 2], corners[(first + 3) % 4]});
      return;
    }
    addElement({corners.begin(), corners.end()});
  }

  void addElement(std::vector<int> corners) {
    Place middle{0, 0};
    for (const int n : corners)
      for (const int axis : {0, 1}) middle[axis] += places[n][axis] / static_cast<double>(corners.size());
    Element element;
    for (std::size_t c = 0; c < block_.circles.size(); ++c)
      if (distance(middle, c) < 0) element.material = static_cast<int>(c) + 1;
    const bool hollow = element.material > 0 && block_.circles[element.material - 1].hollow;
    if (hollow) return;
    element.nodes = corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const int a = corners[k], b = corners[(k + 1) % corners.size()], m = middleOf(a, b);
      element.nodes.push_back(m);
      for (std::size_t c = 0; c < block_.circles.size(); ++c)
        if (block_.circles[c].hollow && onCircle(a, b, c))
          holes[c].push_back({static_cast<int>(elements.size()), static_cast<int>(k) + 1, {a, m, b}});
    }
    elements.push_back(element);
  }

  bool onCircle(int a, int b, std::size_t circle) const {
    return std::abs(distance(places[a], circle)) < kOn_mm && std::abs(distance(places[b], circle)) < kOn_mm;
  }

  int middleOf(int a, int b) {
    const auto [found, isNew] = middles_.try_emplace({std::min(a, b), std::max(a, b)}, int(places.size()));
    if (!isNew) return found->second;
    Place middle{(places[a][0] + places[b][0]) / 2, (places[a][1] + places[b][1]) / 2};
    for (std::size_t c = 0; c < block_.circles.size(); ++c)
      if (onCircle(a, b, c)) middle = projected(middle, c);
    places.push_back(middle);
    return found->second;
  }

  void dropUnused() {
    std::vector<int> number(places.size(), -1);
    std::vector<Place> used;
    const auto keep = [&](int& n) {
      if (number[n] < 0) {
        number[n] = static_cast<int>(used.size());
        used.push_back(places[n]);
      }
      n = number[n];
    };
    for (Element& element : elements)
      for (int& n : element.nodes) keep(n);
    for (auto& hole : holes)
      for (Hole& edge : hole)
        for (int& n : edge.nodes) keep(n);
    places = used;
  }

  const CalculixBlock& block_;
  int columns_ = 0, rows_ = 0;
  std::map<std::pair<int, int>, int> middles_;
};

/// U = C10 (I1' - 3) + 1/D1 (J - 1)^2, I1' that of F / J^(1/3).
void writeMaterial(std::ofstream& file, const std::string& name, const CalculixBlock::Material& m) {
  const double mu = m.young_kPa / (2 * (1 + m.poisson)), bulk = m.young_kPa / (3 * (1 - 2 * m.poisson));
  file << "*MATERIAL, NAME=" << name << "\n*HYPERELASTIC, NEO HOOKE\n" << mu / 2 << ", " << 2 / bulk << "\n";
  file << "*SOLID SECTION, ELSET=" << name << ", MATERIAL=" << name << "\n1.\n";
}

std::string setName(int material, std::size_t corners) {
  return "M" + std::to_string(material) + (corners == 6 ? "T" : "Q");
}

void writeElements(std::ofstream& file, const Mesh& mesh, std::size_t corners) {
  for (int material = 0; material <= int(mesh.holes.size()); ++material) {
    bool begun = false;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      const auto& element = mesh.elements[e];
      if (element.material != material || element.nodes.size() != corners) continue;
      if (!begun)
        file << "*ELEMENT, TYPE=" << (corners == 6 ? "CPE6" : "CPE8") << ", ELSET=" << setName(material, corners)
             << "\n";
      begun = true;
      file << e + 1;
      for (const int n : element.nodes) file << ", " << n + 1;
      file << "\n";
    }
  }
}

void writeInput(const CalculixBlock& block, const Mesh& mesh, const std::filesystem::path& path) {
  std::ofstream file(path);
  file.precision(10);
  file << "*NODE, NSET=ALL\n";
  for (std::size_t n = 0; n < mesh.places.size(); ++n)
    file << n + 1 << ", " << mesh.places[n][0] << ", " << -mesh.places[n][1] << ", 0\n";
  writeElements(file, mesh, 8);
  writeElements(file, mesh, 6);
  for (int m = 0; m <= static_cast<int>(block.circles.size()); ++m)
    for (const std::size_t corners : {6, 8})
      if (std::any_of(mesh.elements.begin(), mesh.elements.end(),
                      [&](const auto& e) { return e.material == m && e.nodes.size() == corners; }))
        writeMaterial(file, setName(m, corners), m == 0 ? block.tissue : block.circles[m - 1].material);
  std::ostringstream held, pressed, pressedSet;
  pressed.precision(10);
  for (std::size_t n = 0; n < mesh.places.size(); ++n) {
    const auto& [x, z] = mesh.places[n];
    if ((block.sidesHeld && std::abs(x) > block.sides_mm - kOn_mm) || z > block.height_mm - kOn_mm)
      held << n + 1 << ", 1, 2\n";
    else if (const auto move = z < kOn_mm ? block.press(x) : std::nullopt) {
      pressed << n + 1 << ", 1, 1, " << (*move)[0] << "\n" << n + 1 << ", 2, 2, " << -(*move)[1] << "\n";
      pressedSet << n + 1 << ",\n";
    }
  }
  file << "*NSET, NSET=TOP\n" << pressedSet.str() << "*BOUNDARY\n" << held.str();
  // Convergence is judged by forces (0.1 %): single nodes at the rim of the vein go on moving when nothing else does.
  file << "*STEP, NLGEOM, INC=500\n*STATIC\n0.25, 1., 1e-4, 0.5\n*CONTROLS, PARAMETERS=FIELD\n0.001, 1.\n*BOUNDARY\n"
       << pressed.str();
  for (std::size_t c = 0; c < mesh.holes.size(); ++c)
    if (block.circles[c].pressure_kPa > 0) {
      file << "*DLOAD\n";
      for (const auto& edge : mesh.holes[c])
        file << edge.element + 1 << ", P" << edge.face << ", " << block.circles[c].pressure_kPa << "\n";
    }
  file << "*NODE PRINT, NSET=ALL, FREQUENCY=1000\nU\n*NODE PRINT, NSET=TOP, TOTALS=ONLY, FREQUENCY=1000\nRF\n*END "
          "STEP\n";
}

bool read(const Mesh& mesh, const std::filesystem::path& path, CalculixAnswer& answer) {
  std::ifstream file(path);
  std::string line;
  std::size_t moved = 0;
  bool forces = false, found = false;
  for (const Place& p : mesh.places) answer.nodes.push_back({p[0], p[1]});
  while (std::getline(file, line)) {
    std::istringstream words(line);
    if (line.find("force") != std::string::npos) forces = true;
    std::size_t node = 0;
    double x = 0, y = 0, z = 0;
    if (forces && (words >> x >> y >> z)) {
      answer.force_kPa_mm = -y;
      found = true;
    } else if (!forces && (words >> node >> x >> y >> z) && node >= 1 && node <= answer.nodes.size()) {
      answer.nodes[node - 1].moveX_mm = x;
      answer.nodes[node - 1].moveZ_mm = -y;
      ++moved;
    }
  }
  return found && moved == answer.nodes.size();
}

/// Green's theorem around the hole, each edge a parabola.
double areaOf(const std::vector<Mesh::Hole>& hole, const CalculixAnswer& answer, bool now) {
  double twice = 0;
  for (const auto& edge : hole) {
    const auto place = [&](int n) {
      const CalculixNode& node = answer.nodes[n];
      return Place{node.x_mm + (now ? node.moveX_mm : 0), node.z_mm + (now ? node.moveZ_mm : 0)};
    };
    const Place a = place(edge.nodes[0]), m = place(edge.nodes[1]), b = place(edge.nodes[2]);
    const auto cross = [](const Place& p, const Place& q) { return p[0] * q[1] - p[1] * q[0]; };
    twice += 4 * (cross(a, m) + cross(m, b)) / 3 - cross(a, b) / 3;
  }
  return std::abs(twice) / 2;
}

}  // namespace

bool calculixIsThere() {
  return std::system("command -v ccx > /dev/null 2>&1") == 0;
}

CalculixAnswer solveWithCalculix(const CalculixBlock& block, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const Mesh mesh(block);
  writeInput(block, mesh, folder / "block.inp");
  std::filesystem::remove(folder / "block.dat");
  CalculixAnswer answer;
  const std::string command = "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 ccx block > block.log 2>&1";
  answer.ran = std::system(command.c_str()) == 0 && read(mesh, folder / "block.dat", answer);
  for (std::size_t c = 0; c < block.circles.size(); ++c)
    if (block.circles[c].hollow) {
      answer.area_mm2.push_back(areaOf(mesh.holes[c], answer, true));
      answer.rest_mm2.push_back(areaOf(mesh.holes[c], answer, false));
    }
  return answer;
}

}  // namespace insonate::test
