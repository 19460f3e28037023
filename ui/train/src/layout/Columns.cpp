#include "Columns.h"

#include <QSettings>
#include <algorithm>

namespace insonate::train {
namespace {

constexpr const char* kColumns = "columns";

}  // namespace

Columns::Columns(QWidget* parent) : QSplitter(Qt::Horizontal, parent) {
  setObjectName("trainColumns");
  setChildrenCollapsible(false);
}

void Columns::set(QWidget* controls, QWidget* image, QWidget* patient) {
  controls_ = controls, image_ = image, patient_ = patient;
  for (QWidget* column : {controls_, image_, patient_})
    if (column) addWidget(column);
  setStretch();
  setSizes({250, 900, 420});
}

void Columns::setStretch() {
  for (int i = 0; i < count(); ++i) setStretchFactor(i, widget(i) == controls_ ? 0 : widget(i) == patient_ ? 1 : 3);
}

void Columns::setLeftHanded(bool isLeftHanded) {
  QWidget *first = isLeftHanded ? patient_ : controls_, *last = isLeftHanded ? controls_ : patient_;
  if (!patient_ || widget(0) == first) return;
  QList<int> widths = sizes();
  std::reverse(widths.begin(), widths.end());
  insertWidget(0, first);
  addWidget(last);
  setStretch();
  setSizes(widths);
}

void Columns::expandPatient(bool isExpanded) {
  isExpanded_ = isExpanded;
  QList<int> widths = sizes();
  if (isExpanded) {
    widthsBefore_ = widths;
    const int aside = indexOf(patient_), middle = indexOf(image_), shared = widths[middle] + widths[aside];
    widths[middle] = shared / 2, widths[aside] = shared - shared / 2;
    setSizes(widths);
  } else if (widthsBefore_.size() == widths.size()) {
    setSizes(widthsBefore_);
  }
}

void Columns::save(QSettings& settings) {
  const bool isExpanded = isExpanded_;
  if (isExpanded) expandPatient(false);
  settings.setValue(kColumns, saveState());
  if (isExpanded) expandPatient(true);
}

void Columns::restore(const QSettings& settings) {
  restoreState(settings.value(kColumns).toByteArray());
}

}  // namespace insonate::train
