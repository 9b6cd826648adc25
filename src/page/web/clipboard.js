/**
 * Makes a button copy a text.
 * @param {function(): string} textOf
 * @param {Node} shown where the text stands: without the right to the clipboard it is selected, to be copied by hand
 */
function copyOnClick(button, textOf, shown) {
  button.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(textOf());
      button.textContent = 'Copied';
    } catch (error) {
      getSelection().selectAllChildren(shown);
      button.textContent = 'Selected';
    }
  });
}
