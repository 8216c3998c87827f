#include "ui/shell/dialogs/thumbnail_view.hpp"

#include <algorithm>
#include <cmath>

namespace replan::ui {

void ThumbnailView::show(Thumbnail thumbnail) {
  clear();
  thumbnail_ = std::move(thumbnail);
}

void ThumbnailView::clear() {
  if (texture_ != nullptr) renderer_->destroy_texture(texture_);
  texture_ = nullptr;
  thumbnail_ = {};
}

void ThumbnailView::draw(const Look& look, ImDrawList& list, ImVec2 min, ImVec2 max) {
  if (thumbnail_.width == 0) return;
  if (texture_ == nullptr || dark_ != look.theme.is_dark) {
    if (texture_ != nullptr) renderer_->destroy_texture(texture_);
    texture_ = renderer_->create_texture(thumbnail_.width, thumbnail_.height,
                                         coloured(thumbnail_, look.theme), Filter::cells);
    dark_ = look.theme.is_dark;
  }
  const auto width = static_cast<float>(thumbnail_.width), height = static_cast<float>(thumbnail_.height);
  const float scale = std::min((max.x - min.x) / width, (max.y - min.y) / height);
  const ImVec2 size(std::floor(width * scale), std::floor(height * scale));
  const ImVec2 from(std::floor((min.x + max.x - size.x) * 0.5f), std::floor((min.y + max.y - size.y) * 0.5f));
  list.AddImage(texture_, from, {from.x + size.x, from.y + size.y});
  const auto mark = [&](const std::optional<Cell>& cell, ImU32 colour) {
    if (!cell) return;
    const ImVec2 at(from.x + (static_cast<float>(cell->x) + 0.5f) * scale,
                    from.y + (static_cast<float>(cell->y) + 0.5f) * scale);
    const float radius = std::max(look.px(4), std::min(scale * 0.4f, look.px(7)));
    list.AddCircleFilled(at, radius + look.px(1), look.theme.outline);
    list.AddCircleFilled(at, radius, colour);
  };
  mark(thumbnail_.start, look.theme.start);
  mark(thumbnail_.goal, look.theme.goal);
}

}  // namespace replan::ui
