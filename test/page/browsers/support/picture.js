// Pixels of a screenshot: PNG of 8 bits a channel, not interlaced, as browsers make it.
import {inflateSync} from 'node:zlib';

const SIGNATURE_LENGTH = 8;

function chunks(png)
{
  const found = [];
  for (let at = SIGNATURE_LENGTH; at < png.length;) {
    const length = png.readUInt32BE(at);
    found.push({type: png.toString('latin1', at + 4, at + 8), data: png.subarray(at + 8, at + 8 + length)});
    at += length + 12;
  }
  return found;
}

function paeth(left, up, corner)
{
  const [a, b, c] = [left, up, corner].map(value => Math.abs(left + up - corner - value));
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

const PREDICTED = [
  () => 0,
  left => left,
  (left, up) => up,
  (left, up) => (left + up) >> 1,
  paeth,
];

/// Width, height and at(x, y) -> [red, green, blue].
export function picture(bytes)
{
  const png = Buffer.from(bytes);
  const parts = chunks(png);
  const header = parts.find(part => part.type === 'IHDR').data;
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  const channels = {2: 3, 6: 4}[header[9]];
  if (header[8] !== 8 || !channels || header[12] !== 0)
    throw new Error(`a PNG of another kind: ${[...header.subarray(8)]}`);
  const raw = inflateSync(Buffer.concat(parts.filter(part => part.type === 'IDAT').map(part => part.data)));
  const stride = width * channels;
  const pixels = Buffer.alloc(stride * height);
  for (let row = 0; row < height; ++row) {
    const predicted = PREDICTED[raw[row * (stride + 1)]];
    for (let k = 0; k < stride; ++k) {
      const at = row * stride + k;
      const left = k >= channels ? pixels[at - channels] : 0;
      const up = row > 0 ? pixels[at - stride] : 0;
      const corner = k >= channels && row > 0 ? pixels[at - stride - channels] : 0;
      pixels[at] = raw[row * (stride + 1) + 1 + k] + predicted(left, up, corner);
    }
  }
  return {
    width, height,
    at: (x, y) => [...pixels.subarray((y * width + x) * channels, (y * width + x) * channels + 3)],
  };
}

/// The most frequent colour of a disk in pixels: marks and lines on it are fewer.
export function colourOfDisk(image, x, y, radius)
{
  const counts = new Map();
  for (let row = Math.ceil(y - radius); row <= y + radius; ++row)
    for (let column = Math.ceil(x - radius); column <= x + radius; ++column)
      if (Math.hypot(column + 0.5 - x, row + 0.5 - y) <= radius - 1) {
        const colour = image.at(column, row).join();
        counts.set(colour, (counts.get(colour) ?? 0) + 1);
      }
  const [most] = [...counts].sort((a, b) => b[1] - a[1]);
  return most?.[0].split(',').map(Number);
}

/// How far apart two colours are: the largest difference of a channel, of 255.
export function difference(one, other)
{
  return Math.max(...one.map((value, k) => Math.abs(value - other[k])));
}

/// How many colours a picture has, at most `enough`.
export function colourCount(image, enough = 100)
{
  const colours = new Set();
  for (let y = 0; y < image.height && colours.size < enough; ++y)
    for (let x = 0; x < image.width; ++x)
      colours.add(image.at(x, y).join());
  return Math.min(colours.size, enough);
}
