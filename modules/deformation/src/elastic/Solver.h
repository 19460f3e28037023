#pragma once

#include "elastic/Contact.h"
#include "elastic/GridFactor.h"
#include "elastic/Materials.h"
#include "elastic/Mesh.h"
#include "elastic/Struts.h"

namespace insonate::elastic {

/// Stress of each cell in the undeformed geometry, kPa: xx, zz and xz are the deviatoric components (with their share
/// of the trace); `volume` is the coefficient of dA, the change of area.
struct Prestress {
  std::vector<float> xx, zz, xz, volume;
  void resize(std::size_t cells) {
    for (auto* v : {&xx, &zz, &xz, &volume}) v->assign(cells, 0.0f);
  }
};

/// Computes the equilibrium of a mesh under the probe's face and blood pressure by mixed Newton steps, each with a new
/// factorization.
class Solver {
 public:
  /// Sets a new undeformed geometry: computes its stiffness, and the prestress that keeps it in equilibrium with the
  /// blood pressures of the CT. If a `known` prestress is given, a constant load compensates its difference from
  /// equilibrium.
  void prepare(const Mesh& mesh, const Materials& materials, const MechanicalTable& tissues,
               const Prestress* known = nullptr);
  const Prestress& prestress() const { return prestress_; }

  void setPressure(const BloodPressure& pressure);

  /// Resets the solution to the undeformed geometry.
  void start();
  /// Positions of the nodes, from which the next solution starts.
  Nodes& at() { return at_; }
  const Nodes& at() const { return at_; }
  std::vector<float>& cellPressure() { return cellPressure_; }
  const std::vector<float>& cellPressure() const { return cellPressure_; }
  /// Starts the next solution from at() and cellPressure().
  void carry();

  struct Load {
    float shift_mm = 0;
    /// If above 0, the required contact force per mm of footprint; the solver then determines shift_mm.
    float force_kPa_mm = 0;
    bool sticking = false;
  };
  struct Patience {
    int maxIterations = 60;
    float tolerance_mm = 0.01f;
    /// A solution that continues an earlier one is accepted when a step is shorter than this.
    float movingTolerance_mm = 0;
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
  std::vector<char> solid_;  ///< [node] true if a cell at the node contains more than blood
  bool atRestPressure_ = true, carried_ = false;
  float caution_ = 0;  ///< parameter `caution` of the next assemble()
  int cautiousRounds_ = 0;
  int rounds_ = 0;  ///< Newton steps since the start of this solution; live imaging takes a few per image
  float last_ = 0;  ///< longest displacement of a node in the last step
};

}  // namespace insonate::elastic
