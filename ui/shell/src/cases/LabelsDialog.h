#pragma once

#include <insonate/cases/LabelFile.h>

#include <QDialog>
#include <QImage>
#include <array>
#include <cstddef>

class QCheckBox;
class QPushButton;
class QVBoxLayout;

namespace insonate::ui {

/// Facts about labels that take a pass over all voxels.
struct LabelsPreview {
  QImage slice;                           ///< see labelPreview()
  std::array<std::size_t, 256> voxels{};  ///< number of voxels by label
};

/// Computes the preview of labels on the grid of `ct`. For any thread.
LabelsPreview labelsPreviewOf(const CtVolume& ct, const LabelReadResult& read);

/// Shows how the labels of a file are understood, with a slice of the CT, before they replace the case's labels. If the
/// file does not say what its numbers mean, they are accepted only once the user states that they are this program's
/// numbers, or names them by another file.
class LabelsDialog : public QDialog {
  Q_OBJECT

 public:
  /// `read` is only used while the dialog is made.
  LabelsDialog(const QString& fileName, const LabelReadResult& read, const LabelsPreview& preview, QWidget* parent);

 Q_SIGNALS:
  void namesWanted();  ///< emitted when the user wants to choose a file that names the numbers

 private:
  void addUnnamed(QVBoxLayout& box);

  QCheckBox* areOurs_ = nullptr;  ///< null if the file names its structures
  QPushButton* replace_;
};

}  // namespace insonate::ui
