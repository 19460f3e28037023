#pragma once

#include "elastic/Contact.h"
#include "elastic/GridFactor.h"
#include "elastic/Materials.h"
#include "elastic/Mesh.h"
#include "elastic/Struts.h"

namespace insonate::elastic {

/// Stress of each cell in the rest geometry, kPa: deviatoric (with its share of the trace), and what stands before dA.
struct Prestress {
  std::vector<float> xx, zz, xz, volume;
  void resize(std::size_t cells) {
    for (auto* v : {&xx, &zz, &xz, &volume}) v->assign(cells, 0.0f);
  }
};

/// Equilibrium of a mesh under a face and blood pressure by mixed Newton steps, each with a fresh factor.
class Solver {
 public:
  /// Sets a new rest geometry: stiffness, and the prestress that makes it an equilibrium under the tissues' own
  /// pressures. With a `known` prestress, a dead load compensates the difference.
  void prepare(const Mesh& mesh, const Materials& materials, const MechanicalTable& tissues,
               const Prestress* known = nullptr);
  const Prestress& prestress() const { return prestress_; }

  void setPressure(const BloodPressure& pressure);

  /// Starts from rest.
  void start();
  /// Positions and pressures of cells above base, to start from.
  Nodes& at() { return at_; }
  const Nodes& at() const { return at_; }
  std::vector<float>& cellPressure() { return cellPressure_; }
  const std::vector<float>& cellPressure() const { return cellPressure_; }
  /// Continues with the cells' present pressures.
  void carry();

  struct Load {
    float shift_mm = 0;
    float force_kPa_mm = 0;  ///< above 0: the shift is found
    bool sticking = false;
  };
  struct Patience {
    int mostIterations = 60;
    float tolerance_mm = 0.01f;
    float enough_mm = 0;  ///< a solution that was carried over is left at a step this small
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
  std::vector<char> solid_;  ///< nodes of cells that are not blood alone
  bool atRestPressure_ = true, carried_ = false;
  float caution_ = 0;  ///< of the next tangents, see assemble()
  int cautiousRounds_ = 0;
  int rounds_ = 0;  ///< since what is solved began: a live image takes a few at a time
  float last_ = 0;  ///< longest step of the last one
};

}  // namespace insonate::elastic
