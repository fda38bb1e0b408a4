//! The last request of one kind to the worker: which answer is current.

/// The last request of one kind: its serial number and its key.
#[derive(Debug)]
pub(crate) struct LastRequest<K>(Option<(u64, K)>);

impl<K> Default for LastRequest<K> {
    fn default() -> Self {
        Self(None)
    }
}

impl<K> LastRequest<K> {
    /// Whether it has the same key.
    pub(crate) fn is(&self, same: impl FnOnce(&K) -> bool) -> bool {
        self.0.as_ref().is_some_and(|(_, key)| same(key))
    }

    /// Stores a sent request.
    pub(crate) fn sent(&mut self, serial: u64, key: K) {
        self.0 = Some((serial, key));
    }

    /// The key of the answer with a serial number; none if another request was sent since.
    pub(crate) fn answered(&self, serial: u64) -> Option<&K> {
        let (last, key) = self.0.as_ref()?;
        (*last == serial).then_some(key)
    }

    /// The serial number, if there is a request.
    pub(crate) fn serial(&self) -> Option<u64> {
        self.0.as_ref().map(|(serial, _)| *serial)
    }

    /// Resets the request: its answer is discarded, and the same key can be requested again.
    pub(crate) fn forget(&mut self) {
        self.0 = None;
    }
}
