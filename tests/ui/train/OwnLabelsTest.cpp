#include "TrainWindow.h"

#include <insonate/tissue/Labels.h>

namespace insonate::train {
namespace {

TEST_F(TrainWindow, LabelsOfTheAuthorsOwnAreTissuesWithoutACopyOfTheCase) {
  const auto authors = std::make_shared<const PatientCase>(test::smallCaseWithOwnLabel(kBone));
  workspace_->setCase(authors);
  EXPECT_FALSE(model_->patientCase.tissueLabels()) << "the window made them itself";
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms));
  EXPECT_EQ(model_->patientCase.patient(), authors);
  EXPECT_EQ(model_->patientCase.tissueLabels()->voxels, test::smallCase().labels.voxels);
  EXPECT_EQ(std::ranges::count(*model_->patientCase.structures(), kBone), 1);
  workspace_->setCase(patient());
  ASSERT_TRUE(QTest::qWaitFor([&] { return model_->patientCase.tissueLabels() != nullptr; }, kPatience_ms));
  EXPECT_EQ(model_->patientCase.tissueLabels().get(), &patient()->labels) << "a copy where nothing changes";
}

}  // namespace
}  // namespace insonate::train
