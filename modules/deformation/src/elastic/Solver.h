#pragma once

#include "elastic/Contact.h"
#include "elastic/GridFactor.h"
#include "elastic/Materials.h"
#include "elastic/Mesh.h"
#include "elastic/Struts.h"

namespace insonate::elastic {

/// Stress of each cell in the rest geometry, kPa: deviatoric components xx, zz, xz (including their share of the
/// trace), and `volume`, the coefficient of dA.
struct Prestress {
  std::vector<float> xx, zz, xz, volume;
  void resize(std::size_t cells) {
    for (auto* v : {&xx, &zz, &xz, &volume}) v->assign(cells, 0.0f);
  }
};

/// Computes the equilibrium of a mesh under a face and blood pressure by mixed Newton steps, each with a new factor.
class Solver {
 public:
  /// Sets a new rest geometry: its stiffness, and the prestress with which it is in equilibrium under the blood
  /// pressures of the CT. If a `known` prestress is given, a dead load compensates the difference from equilibrium.
  void prepare(const Mesh& mesh, const Materials& materials, const MechanicalTable& tissues,
               const Prestress* known = nullptr);
  const Prestress& prestress() const { return prestress_; }

  void setPressure(const BloodPressure& pressure);

  /// Resets the solution to rest.
  void start();
  /// Positions of nodes, from which the next solution starts.
  Nodes& at() { return at_; }
  const Nodes& at() const { return at_; }
  std::vector<float>& cellPressure() { return cellPressure_; }
  const std::vector<float>& cellPressure() const { return cellPressure_; }
  /// Starts the next solution from at() and cellPressure().
  void carry();

  struct Load {
    float shift_mm = 0;
    float force_kPa_mm = 0;  ///< if above 0, the solver determines the shift that gives this force
    bool sticking = false;
  };
  struct Patience {
    int mostIterations = 60;
    float tolerance_mm = 0.01f;
    float enough_mm = 0;  ///< a carried-over solution is accepted at a step shorter than this
  };
  struct Outcome {
    int iterations = 0;
    bool converged = false, finite = false;
    float shift_mm = 0, force_kPa_mm = 0;
  };
  Outcome solve(const FaceProfile& face, Load load, const Patience& patience);

  bool atRestPressure() const { return atRestPressure_; }
  const Elements& elements() const { return elements_; }

 private:
  void findPrestress();
  void applyPrestress();
  void system(float caution);
  void hold();
  bool inReach() const;
  float longestStep() const;
  float followForce(float wanted_kPa_mm, float shift_mm);
  void pressed(const Load& load, float shift_mm);
  float slope(const Load& load, float shift_mm, float shiftChange) const;
  void drawBack(const Load& load, float before, float shiftChange, float& shift_mm);

  Elements elements_;
  Contact contact_;
  Struts struts_;
  GridMatrix matrix_;
  GridFactor factor_;
  Nodes rest_, at_;
  Prestress prestress_;
  std::vector<float> force_, dead_, step_, byShift_, response_, cellPressure_, restBase_;
  const Materials* materials_ = nullptr;
  BloodPressure restPressure_;
  std::vector<char> solid_;  ///< nodes of cells that are not only blood
  bool atRestPressure_ = true, carried_ = false;
  float caution_ = 0;  ///< caution of the next tangents; see assemble()
  int cautiousRounds_ = 0;
  int rounds_ = 0;  ///< steps since the start of this solution; a live image takes a few at a time
  float last_ = 0;  ///< longest displacement in the last step
};

}  // namespace insonate::elastic
