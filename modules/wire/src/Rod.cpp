#include "Rod.h"

#include <algorithm>
#include <cmath>

namespace insonate::wire {
namespace {

/// Resistance to stretch and shear: far above all other forces, so that wires keep their length within 0.1 %.
constexpr double kStretch_N = 2e4;
/// Torsional stiffness by bending stiffness: 1 / (1 + 0.3) for a solid round wire; less for a coil.
constexpr double kTwistShare = 0.77;

Matrix skew(const Vector& v) {
  Matrix m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

Rod::Rod(int maxSegments)
    : node(maxSegments + 1, Vector::Zero()),
      load_N(maxSegments + 1, Vector::Zero()),
      frame(maxSegments + 1, Frame::Identity()),
      length_mm(maxSegments, 0.0) {}

void Rod::copyFrom(const Rod& other) {
  segments = other.segments;
  std::copy_n(other.node.begin(), segments + 1, node.begin());
  std::copy_n(other.load_N.begin(), segments + 1, load_N.begin());
  std::copy_n(other.frame.begin(), segments + 1, frame.begin());
  std::copy_n(other.length_mm.begin(), segments, length_mm.begin());
}

RodMaterial::RodMaterial(const Wire& wire, double spacing_mm, int maxSegments) {
  constexpr int kSamples = 16;
  const auto sectionAt = [&](double s_mm) -> const WireSection& {
    double end_mm = 0;
    for (const WireSection& section : wire.sections)
      if (s_mm < (end_mm += section.length_mm)) return section;
    return wire.sections.back();
  };
  for (int n = 0; n <= maxSegments; ++n) {
    double flexibility = 0, rest = 0, kink = 0;
    for (int k = 0; k < kSamples; ++k) {
      const double s_mm = std::max(0.0, (n + (k + 0.5) / kSamples - 0.5) * spacing_mm);
      const WireSection& section = sectionAt(s_mm);
      flexibility += 1 / section.bendingStiffness_Nmm2 / kSamples;
      rest += section.restRadius_mm > 0 ? 1 / section.restRadius_mm / kSamples : 0;
      kink = std::max(kink, 1 / section.kinkRadius_mm);
    }
    bending_.push_back(1 / flexibility), rest_.push_back(rest), kink_.push_back(kink);
    if (rest > 0) curved_ = n + 1;
  }
}

RodEnergy::Bend RodEnergy::bendAt(const Rod& rod, int node) const {
  const bool isClamp = node == rod.segments;
  const double length_mm = (rod.length_mm[node - 1] + (isClamp ? 0 : rod.length_mm[node])) / 2;
  Frame relative = rod.frame[node].conjugate() * rod.frame[node - 1];
  if (relative.w() < 0) relative.coeffs() *= -1;
  const Vector rest(0, material_.restCurvature_1pmm(node), 0);
  const double bending = material_.bending_Nmm2(node);
  return {length_mm, relative, relative.vec() * (2 / length_mm) - rest,
          Vector(bending, bending, kTwistShare * bending)};
}

double RodEnergy::curvature_1pmm(const Rod& rod, int node) const {
  const Bend bend = bendAt(rod, node);
  const Vector curvature = bend.relative.vec() * (2 / bend.length_mm);
  return std::hypot(curvature.x(), curvature.y());
}

RodEnergy::Contact RodEnergy::contactAt(const Rod& rod, int node) const {
  Contact contact;
  contact.wall = tree_.wallAt(system_, vec3(rod.node[node]));
  contact.depth_mm = std::max(contact.wall.distance_mm + radius_mm_, 0.0);
  const double before_mm = node > 0 ? rod.length_mm[node - 1] : 0;
  const double behind_mm = node < rod.segments ? rod.length_mm[node] : 0;
  contact.stiffness_Npmm = settings_.wallStiffness_Npmm2 * (before_mm + behind_mm) / 2;
  if (node == 0) contact.stiffness_Npmm += settings_.tipStiffness_Npmm;
  return contact;
}

double RodEnergy::energy(const Rod& rod) const {
  double sum = 0;
  for (int j = 0; j < rod.segments; ++j) {
    const Vector strain = (rod.node[j] - rod.node[j + 1]) / rod.length_mm[j] - rod.frame[j] * Vector::UnitZ();
    sum += 0.5 * kStretch_N * rod.length_mm[j] * strain.squaredNorm();
    const Bend bend = bendAt(rod, j + 1);
    sum += 0.5 * bend.length_mm * bend.strain.cwiseAbs2().dot(bend.stiffness);
    const Contact contact = contactAt(rod, j);
    sum += 0.5 * contact.stiffness_Npmm * contact.depth_mm * contact.depth_mm - rod.load_N[j].dot(rod.node[j]);
  }
  return sum;
}

void RodEnergy::assemble(const Rod& rod, std::vector<BlockVector>& gradient, BlockSolver& equations) const {
  const int count = rod.segments;
  for (int j = 0; j < count; ++j) gradient[j].setZero(), equations.diagonal[j].setZero(), equations.beside[j].setZero();
  const Vector z = Vector::UnitZ();
  for (int j = 0; j < count; ++j) {
    // Stretch and shear: k l / 2 |e - d3|^2, with d3 = R (z + w x z + (w (w.z) - z |w|^2) / 2).
    const double length_mm = rod.length_mm[j];
    const Matrix rotation = rod.frame[j].toRotationMatrix();
    const Vector e = (rod.node[j] - rod.node[j + 1]) / length_mm;
    const Vector body = rotation.transpose() * e;
    const Vector force = kStretch_N * (e - rotation.col(2));
    const Matrix turn = kStretch_N * rotation * skew(z);
    const Matrix isotropic = Matrix::Identity() * (kStretch_N / length_mm);
    gradient[j].head<3>() += force;
    gradient[j].tail<3>() -= kStretch_N * length_mm * z.cross(body);
    Block& here = equations.diagonal[j];
    here.topLeftCorner<3, 3>() += isotropic;
    here.topRightCorner<3, 3>() += turn;
    here.bottomLeftCorner<3, 3>() += turn.transpose();
    here.bottomRightCorner<3, 3>() -=
        kStretch_N * length_mm * (0.5 * (body * z.transpose() + z * body.transpose()) - body.z() * Matrix::Identity());
    if (j + 1 < count) {
      gradient[j + 1].head<3>() -= force;
      equations.diagonal[j + 1].topLeftCorner<3, 3>() += isotropic;
      equations.beside[j].topLeftCorner<3, 3>() -= isotropic;
      equations.beside[j].bottomLeftCorner<3, 3>() -= turn.transpose();
    }
    // Bending and twist at node j + 1: l / 2 (u - u0)^T K (u - u0), with u = 2 / l Im(conj(q[j+1]) q[j]).
    const Bend bend = bendAt(rod, j + 1);
    const Vector v = bend.relative.vec(), moment = bend.stiffness.cwiseProduct(bend.strain);
    const double s = bend.relative.w(), mv = moment.dot(v);
    const Matrix identity = Matrix::Identity();
    const Matrix toTip = s * identity + skew(v), toNeedle = skew(v) - s * identity;  // times 1 / l
    const Matrix stiffness = bend.stiffness.asDiagonal() * identity / bend.length_mm;
    gradient[j].tail<3>() += toTip.transpose() * moment;
    here.bottomRightCorner<3, 3>() += toTip.transpose() * stiffness * toTip - 0.5 * mv * identity;
    if (j + 1 < count) {
      gradient[j + 1].tail<3>() += toNeedle.transpose() * moment;
      equations.diagonal[j + 1].bottomRightCorner<3, 3>() +=
          toNeedle.transpose() * stiffness * toNeedle - 0.5 * mv * identity;
      const Matrix mixed = 0.5 * (s * skew(moment) + v * moment.transpose() + moment * v.transpose() - mv * identity);
      equations.beside[j].bottomRightCorner<3, 3>() += toTip.transpose() * stiffness * toNeedle + mixed.transpose();
    }
    const Contact contact = contactAt(rod, j);
    gradient[j].head<3>() -= rod.load_N[j];
    if (contact.depth_mm > 0) {
      const Vector n = eigen(contact.wall.outward), t = eigen(contact.wall.axis);
      const double force_N = contact.stiffness_Npmm * contact.depth_mm;
      gradient[j].head<3>() += force_N * n;
      here.topLeftCorner<3, 3>() += contact.stiffness_Npmm * n * n.transpose();
      const Vector around = t.cross(n);
      here.topLeftCorner<3, 3>() += force_N * contact.wall.curvature_1pmm * around * around.transpose();
    }
  }
}

double RodEnergy::pushOnNeedle_N(const Rod& rod) const {
  const int last = rod.segments - 1;
  const Vector along = rod.frame[rod.segments] * Vector::UnitZ();
  const Vector strain = (rod.node[last] - rod.node[last + 1]) / rod.length_mm[last] - rod.frame[last] * Vector::UnitZ();
  return -kStretch_N * strain.dot(along);
}

}  // namespace insonate::wire
