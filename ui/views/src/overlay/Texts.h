#pragma once

#include <insonate/views/Input.h>
#include <insonate/views/Theme.h>

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkRenderer;
class vtkTextActor;

namespace insonate::views {

enum class Across { Left, Center, Right };
enum class Along { Top, Center, Bottom };

struct TextStyle {
  double size_px = 13;
  Color color = theme::kText;
  bool bold = false;
  Across across = Across::Left;  ///< part of the text that lies at the given point
  Along along = Along::Top;
};

/// Draws texts over a view. Actors are reused from one layout to the next, so that unchanged texts take no time.
class Texts {
 public:
  explicit Texts(vtkRenderer& renderer) : renderer_(renderer) {}

  void begin(int height_px);
  void put(DisplayPoint at, const std::string& words, const TextStyle& style);
  /// Hides texts that were not drawn by put() since begin().
  void end();

 private:
  struct Item {
    vtkSmartPointer<vtkTextActor> actor;
    std::string words;
  };
  vtkRenderer& renderer_;
  std::vector<Item> items_;
  std::size_t used_ = 0;
  int height_px_ = 1;
};

}  // namespace insonate::views
