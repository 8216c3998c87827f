// Freeing large things off the thread that has no more use for them.
#pragma once

#include <memory>
#include <utility>

namespace replan {

/// Destroys what it is given, on a thread of its own, soon. Giving a gigabyte back takes a tenth of a second.
/// Things given one after the other are destroyed in that order, and before the program ends.
void dispose_of(std::shared_ptr<void> thing);
/// From now on each is destroyed where it is given: for programs that work in step, as those without threads do.
void dispose_at_once();

template <class T>
void dispose(T&& thing) {
  dispose_of(std::make_shared<std::decay_t<T>>(std::forward<T>(thing)));
}

}  // namespace replan
