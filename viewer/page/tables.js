// SPDX-License-Identifier: Apache-2.0
// Tables that sort by a click on a head, and switches of layers in drawings.
{
  const value = (row, column) => {
    const text = row.cells[column].textContent.trim();
    const number = parseFloat(text.replace(/[, \u00a0\u202f](?=\d{3})/g, ''));
    return Number.isNaN(number) ? text : number;
  };
  const compare = (a, b) => (typeof a === 'number' && typeof b === 'number' ? a - b : String(a).localeCompare(String(b), 'en', { numeric: true }));
  document.addEventListener('click', (event) => {
    const head = event.target.closest('table.sortable th');
    if (!head) return;
    const column = head.cellIndex, table = head.closest('table'), body = table.tBodies[0];
    const down = head.dataset.order !== 'down' && head.classList.contains('n') || head.dataset.order === 'up';
    for (const other of head.parentNode.cells) delete other.dataset.order;
    head.dataset.order = down ? 'down' : 'up';
    const rows = [...body.rows].map((row, i) => ({ row, i, key: value(row, column) }));
    rows.sort((a, b) => (down ? compare(b.key, a.key) : compare(a.key, b.key)) || a.i - b.i);
    body.append(...rows.map((r) => r.row));
  });
  document.addEventListener('change', (event) => {
    const box = event.target.closest('.sheet figure input');
    if (!box) return;
    const figure = box.closest('figure');
    if (box.value === 'proof') figure.classList.toggle('proof', box.checked);
    for (const part of figure.querySelectorAll('.' + box.value)) part.style.display = box.checked ? 'inline' : 'none';
  });
}
