#include "Neck.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/Labels.h>

namespace insonate::test {

const Neck& neck() {
  static const Neck kNeck = [] {
    Neck neck;
    neck.patient = std::make_shared<PatientCase>(makePhantom("textbook", 1).value());
    neck.shown = std::make_shared<views::VtkCase>(neck.patient);
    neck.setup.probe = loadProbe("linear").value();
    neck.setup.settings = settingsFor(neck.setup.probe);
    neck.setup.tissues = loadAcousticTable("neck").value();
    const PosePath path = readPoses("auto", *neck.patient).value();
    neck.patientFromProbe = path.patientFromProbe.front();
    const SceneRun run = sceneRuns(neck.setup, path.patientFromProbe).front();
    const auto scene = makeScene(*neck.patient, neck.setup, run.region).value();
    ImagingFrame frame;
    Imager::make(neck.setup).value().render(*scene, neck.patientFromProbe, frame);
    neck.image = frame.image;
    return neck;
  }();
  return kNeck;
}

std::shared_ptr<PatientCase> oneVoxel(const VolumeGeometry& grid, int i, int j, int k) {
  auto patient = std::make_shared<PatientCase>(PatientCase{{}, CtVolume(grid, -1000), LabelMap(grid)});
  patient->ct.at(i, j, k) = 1000;
  patient->labels.at(i, j, k) = kBone;
  return patient;
}

}  // namespace insonate::test
