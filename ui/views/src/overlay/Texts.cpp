#include "Texts.h"

#include "../Text.h"

#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>

namespace insonate::views {

void Texts::begin(int height_px) {
  height_px_ = height_px;
  used_ = 0;
}

void Texts::put(DisplayPoint at, const std::string& words, const TextStyle& style) {
  if (used_ == items_.size()) {
    Item item{vtkSmartPointer<vtkTextActor>::New(), {}};
    item.actor->SetTextScaleModeToNone();
    item.actor->SetLayerNumber(2);
    renderer_.AddActor2D(item.actor);
    items_.push_back(std::move(item));
  }
  Item& item = items_[used_++];
  if (item.words != words) item.actor->SetInput((item.words = words).c_str());
  vtkTextProperty& property = *item.actor->GetTextProperty();
  useSystemSans(property, style.size_px, style.color, style.bold);
  property.SetJustification(static_cast<int>(style.across));
  property.SetVerticalJustification(style.along == Along::Top      ? VTK_TEXT_TOP
                                    : style.along == Along::Center ? VTK_TEXT_CENTERED
                                                                   : VTK_TEXT_BOTTOM);
  item.actor->SetPosition(std::round(at.x), std::round(height_px_ - at.y));
  item.actor->SetVisibility(!words.empty());
}

void Texts::end() {
  for (std::size_t k = used_; k < items_.size(); ++k) items_[k].actor->SetVisibility(false);
}

}  // namespace insonate::views
