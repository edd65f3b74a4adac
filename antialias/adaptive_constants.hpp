#pragma once

namespace raycat {

/// What adaptive antialiasing takes for granted where samples do not tell. What these numbers do to
/// pictures is measured (docs/antialiasing.md, Constants).
struct AdaptiveConstants {
  /// Along an axis on which no sample beyond a square shows how its colour bends: what the mean of
  /// its corners may be off by, as a part of the greatest distance of two of them. A twelfth would
  /// be a second difference as great as that distance.
  float unseen_bend = 0.08f;

  /// Corners that are less apart than this part of the greatest distance of two are taken for one
  /// surface, and no border is looked for between them, however small the error that is allowed.
  float one_surface = 0.15f;

  /// When the centre of a square is of the other part than a border's chord says: up to which part
  /// of the square, at least a half, that the chord gives to the centre's supposed part the border
  /// may be a bent one. Beyond it the chord is wrong by as much as the two parts are apart. From
  /// 0.59 on it decides nothing, since `harmless_bend` then refuses the chord too.
  float bent_border = 0.62f;

  /// How wrong the chord is of such a bent border: by twice as much of what the parts are apart as
  /// the centre's supposed part takes of the square beyond this. Less than a half, so that a centre
  /// on the wrong side always counts.
  float harmless_bend = 0.45f;
};

}  // namespace raycat
