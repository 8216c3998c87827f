// Links to a moment: what of the window goes into one, and what of it comes back.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/background.hpp"
#include "core/base/deadline.hpp"
#include "core/link/link.hpp"
#include "core/session/session.hpp"
#include "core/trace/log_hash.hpp"
#include "ui/canvas/view_state.hpp"

namespace replan::ui {

/// What a link says of the moment and the look, but for the hash of the log, which takes long where that is long.
LinkView link_view(const Session& session, const ViewState& view);
/// The world of a session as a link holds it: what is looked for in it goes along.
Scenario link_world(const Session& session);
/// Looks at what a link says; in a window the theme stays the user's own.
void show_link(const LinkView& link, ViewState& view);
/// What of it is about a world of several layers.
void show_link_layers(const LinkView& link, ViewState& view);

/// A link that is being made: the log is read some of it in each frame, then the world is packed beside the window.
class LinkCopy {
 public:
  LinkCopy(const Session& session, LinkView view, const WorkPlace& place);

  /// Goes on until the deadline; the link, from # on, once it is complete.
  std::optional<Result<std::string>> go_on(const Session& session, const Deadline& deadline);

 private:
  LinkView view_;
  LogHash hash_;
  std::uint64_t log_;  // Run::log_id() of what is read
  std::shared_ptr<const Scenario> world_;
  bool packing_ = false;
  Background<Result<std::string>> text_;
};

/// The link to where a session stands, all of it at once.
Result<std::string> link_here(const Session& session, const ViewState& view);

}  // namespace replan::ui
