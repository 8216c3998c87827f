#include "core/world/formats/pnm.hpp"

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(pnm) {
  const auto picture = decode_pnm(input, "f.pgm");
  require_good_error(picture, "f.pgm:");
  if (!picture || picture->channels != 1) return;
  const auto again = decode_pnm(pgm_text(*picture), "again.pgm");
  require(again.ok() && *again == *picture, "what was written is read back equal");
}
