#pragma once

#include <insonate/curriculum/Curriculum.h>
#include <insonate/ui/Widgets.h>

#include <QString>
#include <functional>

namespace insonate::ui {

/// A change of one level. It is emitted together with the name of the changed field, as in
/// CurriculumController::edit().
using LevelEdit = std::function<void(Level&)>;

/// Sets a field's text without moving the cursor while the user types.
template <class Field>
void showText(Field& field, const QString& text) {
  if (field.text() != text) field.setText(text);
}

}  // namespace insonate::ui
