#include "reference/tracing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glm/exponential.hpp>

namespace raycat::reference {
namespace {

const Vec none(0.0L);

// glTF's cone (KHR_lights_punctual): full within the inner angle, nothing beyond the outer.
Real in_cone(const Light& light, const Vec& away) {
  const Real inner = std::cos(Real(light.inner_cone));
  const Real outer = std::cos(Real(light.outer_cone));
  const Real cosine = glm::dot(Vec(light.direction), away);
  const Real part = cosine >= inner ? 1.0L : std::max(0.0L, (cosine - outer) / (inner - outer));
  return part * part;
}

// What is left of a lamp's light at a distance.
Real at_distance(const Light& light, Real distance) {
  const Real window = 1.0L - std::pow(distance / Real(light.range), 4.0L);
  return std::max(0.0L, window) / (light.inverse_square ? distance * distance : 1.0L);
}

Vec reflect(const Vec& direction, const Vec& normal) {
  return glm::normalize(direction - 2.0L * glm::dot(direction, normal) * normal);
}

// Materials do not say so yet.
template <typename M>
bool single_sided(const M& material) {
  if constexpr (requires { material.single_sided; }) {
    return material.single_sided;
  } else {
    return false;
  }
}

// Snell's law; nothing on total reflection.
std::optional<Vec> refract(const Vec& direction, const Vec& normal, Real from, Real to) {
  const Real eta = from / to;
  const Real cosine = -glm::dot(direction, normal);
  const Real rest = 1.0L - eta * eta * (1.0L - cosine * cosine);
  if (rest < 0.0L) {
    return std::nullopt;
  }
  return glm::normalize(eta * direction + (eta * cosine - std::sqrt(rest)) * normal);
}

}  // namespace

Tracing::Media Tracing::with(const Media& media, const Meeting& hit) {
  Media result(media);
  if (hit.material->thin) {
    return result;
  }
  if (hit.entering) {
    result.push_back({.object = hit.object,
                      .ior = hit.material->ior,
                      .absorption = Vec(hit.material->absorption)});
    return result;
  }
  for (std::size_t i = result.size(); i-- > 0;) {
    if (result[i].object == hit.object) {
      result.erase(result.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
  return result;
}

Tracing::Passing Tracing::pass(const Vec& direction, const Meeting& hit, const Vec& normal,
                               const std::vector<Meeting>& place, const Media& media,
                               bool bent) const {
  Passing result{.direction = direction, .media = with(media, hit)};
  if (hit.material->thin || bent) {
    return result;
  }
  // Into what the ray is in behind the place, or before what is opaque there.
  Media beyond(result.media);
  for (const Meeting& next : place) {
    if (!transmits(*next.material)) {
      break;
    }
    beyond = with(beyond, next);
  }
  const auto ior = [](const Media& in) { return in.empty() ? 1.0L : in.back().ior; };
  // Out of what is not the innermost, the ray has been in the innermost, and stays there.
  const bool within = rules_.straight_out_of_overlap && !hit.entering && !media.empty() &&
                      media.back().object != hit.object;
  const Real from = hit.entering || within ? ior(media) : Real(hit.material->ior);
  result.direction = refract(direction, normal, from, ior(beyond));
  return result;
}

Vec Tracing::let_through(const Way& way, Real end) const {
  struct Inside {
    int times = 0;  // of shells that overlap
    Real since = 0.0L;
    Vec absorption{0.0L};
  };
  std::map<ObjectId, Inside> objects;
  Vec light(1.0L);
  const auto absorb = [&](const Vec& absorption, Real length) {
    for (int c = 0; c < 3; ++c) {
      light[c] *= absorption[c] > 0.0L ? std::exp(-absorption[c] * length) : 1.0L;
    }
  };
  for (const Meeting& m : around_.ahead(way)) {
    if (m.t >= end) {
      break;
    }
    light *= Vec(m.material->transmission);
    Inside& inside = objects[m.object];
    if (inside.times == 0) {
      inside.absorption = Vec(m.material->absorption);
    }
    if (m.entering && inside.times++ == 0) {
      inside.since = m.t;
    } else if (!m.entering && --inside.times <= 0) {  // below none if the ray starts inside
      absorb(inside.absorption, m.t - inside.since);
      inside.times = 0;
    }
  }
  for (const auto& [object, inside] : objects) {
    if (inside.times > 0) {
      absorb(inside.absorption, end - inside.since);
    }
  }
  return light;
}

Vec Tracing::arriving(const Light& light, const Meeting& hit, const Vec& point, const Vec& normal,
                      const Vec& facet, const Vec& lifted, Vec& towards) const {
  Real distance = std::numeric_limits<Real>::infinity();
  Real strength = 1.0L;
  if (light.kind == Light::Kind::directional) {
    towards = -glm::normalize(Vec(light.direction));
  } else {
    distance = glm::length(Vec(light.position) - point);
    towards = (Vec(light.position) - point) / distance;
    strength = at_distance(light, distance);
    if (light.kind == Light::Kind::spot) {
      strength *= in_cone(light, -towards);
    }
  }
  if (rules_.lights_by_factors && hit.material->diffuse == glm::vec3(0.0f) &&
      hit.material->specular == glm::vec3(0.0f)) {
    return none;
  }
  if (strength <= 0.0L || glm::dot(normal, towards) <= 0.0L) {
    return none;
  }
  Meeting from(hit);
  from.t = 0.0L;
  const Real end =
      light.kind == Light::Kind::directional ? distance : glm::length(Vec(light.position) - lifted);
  Way way{.line = {.origin = lifted, .direction = towards}, .from = from};
  if (glm::dot(facet, towards) <= 0.0L) {  // by an interpolated normal alone it faces the light
    way.line.origin += around_.hair() * facet;
    way.from.reset();
  }
  const Vec share = let_through(way, end);
  return strength * Vec(glm::vec3(share));  // less than a float can hold is nothing
}

Vec Tracing::trace(const Way& way, const Media& media, HeapPosition position, bool bent,
                   RayTree& tree) const {
  std::vector<Meeting> met = around_.ahead(way);
  if (rules_.back_faces_unseen) {
    std::erase_if(met, [](const Meeting& m) {
      return m.facet != nullptr && !m.entering && single_sided(*m.material);
    });
  }
  if (met.empty()) {
    return Vec(around_.scene().background);
  }
  const Scene& scene = around_.scene();
  const Meeting& hit = met.front();
  const Material& material = *hit.material;
  const Vec& direction = way.line.direction;
  const Vec point = way.line.at(hit.t);
  const Real side = glm::dot(direction, hit.normal) > 0.0L ? -1.0L : 1.0L;
  const Vec facet = side * hit.normal;  // towards where the ray comes from, as is the other
  Vec normal = side * Surroundings::shading_normal(hit);
  if (glm::dot(direction, normal) > 0.0L) {
    normal = facet;
  }
  const Vec lifted = Surroundings::lifted(hit, point, side);

  Vec colour = Vec(material.emission) + Vec(material.ambient) * Vec(scene.ambient_light);
  RayNode node{.position = position, .surface = hit.surface};
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    Vec towards;
    const Vec arrives = arriving(light, hit, point, normal, facet, lifted, towards);
    if (arrives == none) {
      continue;
    }
    node.lights |= LightMask{1} << i;
    const Vec half = glm::normalize(towards - direction);
    colour +=
        arrives * (Vec(material.diffuse) * Vec(light.diffuse) * glm::dot(normal, towards) +
                   Vec(material.specular) * Vec(light.specular) *
                       std::pow(std::max(0.0L, glm::dot(normal, half)), Real(material.shininess)));
  }

  if (material.blend) {
    colour *= std::min(1.0L, Real(material.alpha));
  }

  if (level(position) < rules_.levels) {
    Meeting from(hit);
    from.t = 0.0L;
    Passing passing{.direction = direction, .media = media};
    if (transmits(material)) {
      std::vector<Meeting> place;
      for (std::size_t i = 1; i < met.size() && around_.in_one_place(direction, hit, met[i]); ++i) {
        place.push_back(met[i]);
      }
      const bool here = way.from && around_.in_one_place(direction, *way.from, hit);
      passing = pass(direction, hit, normal, place, media, bent && here);
    }
    Vec k_s(material.reflection);
    Vec k_t(material.transmission);
    if (!passing.direction) {
      k_s += k_t;
    } else if (material.fresnel) {
      // Schlick's angle is that on the thinner side, where the cosine is the lesser one.
      const Real cosine = std::min(std::abs(glm::dot(direction, normal)),
                                   std::abs(glm::dot(*passing.direction, normal)));
      const Real grazing = std::pow(1.0L - cosine, 5.0L);
      k_s = glm::mix(k_s, Vec(material.grazing_reflection), grazing);
      k_t *= 1.0L - grazing;
    }
    if (transmits(material) && passing.direction) {
      const bool back = glm::dot(*passing.direction, facet) >= 0.0L;  // out of the surface again
      colour +=
          k_t *
          trace({.line = {.origin = point, .direction = back ? direction : *passing.direction},
                 .from = from},
                passing.media, refracted(position), !material.thin, tree);
    }
    if (material.reflection != glm::vec3(0.0f) || !passing.direction) {
      const Vec mirrored = reflect(direction, normal);
      const bool back = glm::dot(mirrored, facet) <= 0.0L;  // into the surface
      colour += k_s * trace({.line = {.origin = point,
                                      .direction = back ? reflect(direction, facet) : mirrored},
                             .from = from},
                            media, reflected(position), false, tree);
    }
  }
  tree.push_back(node);
  return media.empty() ? colour : colour * glm::exp(-hit.t * media.back().absorption);
}

Traced Tracing::operator()(const Line& line) const {
  Traced traced;
  traced.colour = trace({.line = line, .from = std::nullopt}, {}, root, false, traced.tree);
  return traced;
}

}  // namespace raycat::reference
