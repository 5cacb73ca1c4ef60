/** Expands an index list of a scene file: an array, or ranges such as "0-3,7". */
export function indices(list: number[] | string): number[] {
  if (typeof list !== 'string') return list;
  if (list.trim() === '') return [];
  return list.split(',').flatMap((range) => {
    const [first, last = first] = range.split('-').map(Number);
    return Array.from({ length: last - first + 1 }, (_, i) => first + i);
  });
}
