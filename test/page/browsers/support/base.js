// The base's surface in the world, from the scene and the recorded drive: docs/model.md.

function corners({tooth_width: width, tooth_height: height, asymmetry, profile})
{
  return profile ?? [[0, 0], [asymmetry * width, height], [width, 0]];
}

/// The drive between two recorded instants: f and A stay the same.
export function baseAt(frames, time)
{
  const k = frames.findLastIndex(frame => frame.time <= time);
  const [from, to] = [frames[k], frames[Math.min(k + 1, frames.length - 1)]];
  const share = to.time > from.time ? (time - from.time) / (to.time - from.time) : 0;
  const phase = from.phase + 2 * Math.PI * from.frequency * (time - from.time);
  return {
    inclination: from.inclination + share * (to.inclination - from.inclination),
    displacement: from.amplitude * Math.sin(phase),
  };
}

/// Into the frame of the base: [s, n].
function within(base, x, y)
{
  const [cos, sin] = [Math.cos(base.inclination), Math.sin(base.inclination)];
  const up = y - base.displacement;
  return [x * cos + up * sin, -x * sin + up * cos];
}

function distanceToFace([s, n], [s0, n0], [s1, n1])
{
  const [along, up] = [s1 - s0, n1 - n0];
  const share = ((s - s0) * along + (n - n0) * up) / (along ** 2 + up ** 2);
  const clamped = Math.min(Math.max(share, 0), 1);
  return Math.hypot(s - s0 - clamped * along, n - n0 - clamped * up);
}

/// How far a centre is from the surface [m], negative below it; undefined beyond the ends.
export function heightAbove(scene, base, x, y)
{
  const [s, n] = within(base, x, y);
  const outline = corners(scene.base);
  const width = outline.at(-1)[0];
  const periodic = scene.boundary === 'periodic';
  if (!periodic && (s < 0 || s > scene.base.teeth * width))
    return undefined;
  const tooth = Math.floor(s / width);
  let nearest = Infinity;
  let below = false;
  for (let shift = tooth - 1; shift <= tooth + 1; ++shift) {
    if (!periodic && (shift < 0 || shift >= scene.base.teeth))
      continue;
    const placed = outline.map(([along, up]) => [along + shift * width, up]);
    for (let k = 0; k + 1 < placed.length; ++k) {
      const [from, to] = [placed[k], placed[k + 1]];
      nearest = Math.min(nearest, distanceToFace([s, n], from, to));
      if (from[0] <= s && s < to[0])
        below ||= n < from[1] + ((s - from[0]) / (to[0] - from[0])) * (to[1] - from[1]);
    }
  }
  return below ? -nearest : nearest;
}
