/** The bytes of an element's base64. */
function bytesOf(id) {
  const text = atob(byId(id).textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The page's data. @return {Promise<{run: Object, series: Object, motion: Uint8Array}>} */
async function readData() {
  const run = JSON.parse(byId('data').textContent);
  const series = JSON.parse(new TextDecoder().decode(await inflated(bytesOf('series'))));
  return {run, series, motion: await inflated(bytesOf('motion'))};
}

/** Reads columns of integers, one after the other: bytePlanes() of src/page/deflate.h. */
class ColumnReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.place = 0;
  }

  /** @return {Float64Array} the next column of doubles */
  nextDoubles(rows) {
    const column = new Float64Array(rows);
    const bytes = new Uint8Array(column.buffer);
    for (let plane = 0; plane < 8; ++plane)
      for (let k = 0; k < rows; ++k) bytes[8 * k + plane] = this.bytes[this.place++];
    return column;
  }

  /** @return {Int32Array} the next column, of so many rows */
  next(rows) {
    const column = new Int32Array(rows);
    for (let plane = 0; plane < 4; ++plane) {
      const shift = 8 * plane;
      for (let k = 0; k < rows; ++k) column[k] |= this.bytes[this.place + k] << shift;
      this.place += rows;
    }
    for (let k = 0; k < rows; ++k) column[k] = (column[k] >>> 1) ^ -(column[k] & 1);
    return column;
  }
}
