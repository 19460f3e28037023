#pragma once

#include <insonate/views/Theme.h>

#include <QPixmap>

namespace insonate::prepare {

/// A small square of a structure's colour.
QPixmap swatch(views::Colour colour);

}  // namespace insonate::prepare
