"""Requirements from other tools: ReqIF and needs.json as requirement documents in Markdown."""
