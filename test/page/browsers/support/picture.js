// Pixels of a canvas.

/// Width, height and at(x, y) -> [red, green, blue] of what is drawn.
export async function picture(page, selector)
{
  const {width, height, pixels} = await page.$eval(selector, canvas => {
    const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let bytes = '';
    for (let k = 0; k < data.length; k += 4096)
      bytes += String.fromCharCode(...data.subarray(k, k + 4096));
    return {width: canvas.width, height: canvas.height, pixels: btoa(bytes)};
  });
  const rgba = Buffer.from(pixels, 'base64');
  return {width, height, at: (x, y) => [...rgba.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)]};
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
